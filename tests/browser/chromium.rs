//! A headless Chromium, driven over the DevTools protocol: what happens in a page, and what it looks
//! like.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde_json::{Value, json};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;
use tungstenite::stream::MaybeTlsStream;
use tungstenite::{Message, WebSocket, connect};

/// Longer than anything here takes, also on a machine that does much else.
const PATIENCE: Duration = Duration::from_secs(120);

/// A browser with one page open.
pub struct Chromium {
    process: Child,
    socket: WebSocket<MaybeTlsStream<TcpStream>>,
    session: Option<String>,
    calls: u64,
    /// What the page told on its own accord, in its order.
    events: Vec<Value>,
    _profile: TempDir,
}

/// A picture of a part of the page: red, green and blue of its pixels, row by row.
#[derive(Clone, PartialEq)]
pub struct Picture {
    pub size: [usize; 2],
    pub pixels: Vec<[u8; 3]>,
}

impl Chromium {
    /// Opens `page` from disk, in a window of 1300 by 900, and listens to it from the start.
    pub fn open(page: &Path) -> Self {
        let profile = tempfile::tempdir().unwrap();
        let mut process = Command::new("chromium")
            .args([
                "--headless=new",
                "--no-sandbox",
                "--disable-dev-shm-usage",
                "--no-first-run",
                "--use-angle=swiftshader",
                "--enable-unsafe-swiftshader",
                "--window-size=1300,900",
                "--remote-debugging-port=0",
                "about:blank",
            ])
            .arg(format!("--user-data-dir={}", profile.path().display()))
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("chromium is installed: `tests/run` does that");
        let address = address(profile.path(), &mut process);
        let (socket, _) = connect(address).expect("chromium answers");
        if let MaybeTlsStream::Plain(stream) = socket.get_ref() {
            stream.set_read_timeout(Some(PATIENCE)).unwrap();
        }
        let mut browser = Self {
            process,
            socket,
            session: None,
            calls: 0,
            events: Vec::new(),
            _profile: profile,
        };
        let target = browser.call("Target.createTarget", json!({ "url": "about:blank" }));
        let target = json!({ "targetId": target["targetId"], "flatten": true });
        let attached = browser.call("Target.attachToTarget", target);
        browser.session = attached["sessionId"].as_str().map(str::to_owned);
        for domain in ["Page", "Runtime", "Log", "Network"] {
            browser.call(&format!("{domain}.enable"), json!({}));
        }
        let url = format!("file://{}", page.display());
        browser.call("Page.navigate", json!({ "url": url }));
        browser
    }

    /// The answer to a command of the protocol.
    pub fn call(&mut self, method: &str, params: Value) -> Value {
        self.calls += 1;
        let mut command = json!({ "id": self.calls, "method": method, "params": params });
        if let Some(session) = &self.session {
            command["sessionId"] = json!(session);
        }
        self.socket
            .send(Message::text(command.to_string()))
            .unwrap();
        loop {
            let message = self.socket.read().expect("chromium answers in time");
            let Message::Text(text) = message else {
                continue;
            };
            let mut message: Value = serde_json::from_str(&text).unwrap();
            if message["id"] == json!(self.calls) {
                assert!(message["error"].is_null(), "{method}: {}", message["error"]);
                return message["result"].take();
            }
            if message["method"].is_string() {
                self.events.push(message);
            }
        }
    }

    /// The value of an expression in the page; a promise is waited for.
    pub fn value(&mut self, expression: &str) -> Value {
        let mut answer = self.call(
            "Runtime.evaluate",
            json!({ "expression": expression, "returnByValue": true, "awaitPromise": true }),
        );
        let failed = &answer["exceptionDetails"];
        assert!(failed.is_null(), "{expression}: {failed}");
        answer["result"]["value"].take()
    }

    /// Waits until an expression is true.
    pub fn wait_for(&mut self, expression: &str) {
        let start = Instant::now();
        while self.value(expression) != json!(true) {
            assert!(start.elapsed() < PATIENCE, "in vain for {expression}");
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    /// Left, top, width and height of an element in the window, after it is scrolled to.
    pub fn place(&mut self, selector: &str) -> [f64; 4] {
        let selector = json!(selector);
        let place = self.value(&format!(
            "(() => {{ const e = document.querySelector({selector}); \
             e.scrollIntoView({{block: 'center', behavior: 'instant'}}); \
             const b = e.getBoundingClientRect(); return [b.left, b.top, b.width, b.height]; }})()"
        ));
        serde_json::from_value(place).unwrap()
    }

    /// What an element looks like.
    pub fn picture(&mut self, selector: &str) -> Picture {
        let [x, y, width, height] = self.place(selector);
        let scrolled = self.value("[scrollX, scrollY]");
        let [left, top]: [f64; 2] = serde_json::from_value(scrolled).unwrap();
        let clip =
            json!({ "x": x + left, "y": y + top, "width": width, "height": height, "scale": 1 });
        let shot = self.call(
            "Page.captureScreenshot",
            json!({ "format": "png", "clip": clip }),
        );
        decode(&STANDARD.decode(shot["data"].as_str().unwrap()).unwrap())
    }

    /// Does something with the mouse: kind, place in the window, and what else there is to say.
    pub fn mouse(&mut self, kind: &str, [x, y]: [f64; 2], more: Value) {
        let mut event = json!({ "type": kind, "x": x, "y": y });
        for (key, value) in more.as_object().into_iter().flatten() {
            event[key] = value.clone();
        }
        self.call("Input.dispatchMouseEvent", event);
    }

    /// Everything that went wrong in the page, and every address it asked for but those that hold
    /// their own content.
    pub fn complaints(&self) -> Vec<String> {
        let complaint = |event: &Value| {
            let params = &event["params"];
            match event["method"].as_str()? {
                "Runtime.exceptionThrown" => Some(params["exceptionDetails"].to_string()),
                "Runtime.consoleAPICalled" => Some(params["args"].to_string()),
                "Log.entryAdded" => Some(params["entry"].to_string()),
                "Network.requestWillBeSent" => {
                    let url = params["request"]["url"].as_str()?;
                    let own = params["documentURL"].as_str() == Some(url);
                    (!own && !url.starts_with("data:")).then(|| format!("asks for {url}"))
                }
                _ => None,
            }
        };
        self.events.iter().filter_map(complaint).collect()
    }
}

impl Drop for Chromium {
    fn drop(&mut self) {
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}

/// Where the browser listens, which it writes into its profile.
fn address(profile: &Path, process: &mut Child) -> String {
    let start = Instant::now();
    loop {
        if let Ok(text) = std::fs::read_to_string(profile.join("DevToolsActivePort"))
            && let Some((port, path)) = text.trim().split_once('\n')
        {
            return format!("ws://127.0.0.1:{port}{path}");
        }
        if let Ok(Some(status)) = process.try_wait() {
            panic!("chromium ended: {status}");
        }
        assert!(start.elapsed() < PATIENCE, "chromium does not listen");
        std::thread::sleep(Duration::from_millis(20));
    }
}

fn decode(bytes: &[u8]) -> Picture {
    let decoder = png::Decoder::new(std::io::Cursor::new(bytes));
    let mut reader = decoder.read_info().unwrap();
    let mut buffer = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut buffer).unwrap();
    let samples = info.color_type.samples();
    Picture {
        size: [info.width as usize, info.height as usize],
        pixels: buffer[..info.buffer_size()]
            .chunks(samples)
            .map(|p| [p[0], p[1], p[2]])
            .collect(),
    }
}

impl Picture {
    /// Pixels that have a colour, and are not white, grey or black.
    pub fn coloured(&self) -> usize {
        let spread = |p: &&[u8; 3]| {
            let (low, high) = (p.iter().min(), p.iter().max());
            high.zip(low).is_some_and(|(h, l)| h - l > 24)
        };
        self.pixels.iter().filter(spread).count()
    }

    /// Pixels that differ from those of another picture of the same size.
    pub fn differs(&self, other: &Self) -> usize {
        assert_eq!(self.size, other.size);
        let pairs = self.pixels.iter().zip(&other.pixels);
        pairs.filter(|(a, b)| a != b).count()
    }
}
