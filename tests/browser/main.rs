//! `report.html` in a real browser: it opens from disk alone, shows the parts and answers to the
//! mouse.

mod chromium;

use brinell::case::{self, Case};
use brinell::product::job::{self, Options};
use brinell::solver::solve::Silent;
use chromium::Chromium;
use serde_json::json;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;
use tempfile::TempDir;

const BODIES: usize = 5;
const CANVAS: &str = "#view canvas";

/// A title and a comment that would break out of a page that trusts them.
const NASTY: &str = "</title><script>window.broken = 1</script>\" onclick=x & <b>bold</b>";

/// The centre bearing on its coarsest mesh, under a nasty name.
fn nasty_case() -> Case {
    let path =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/section-2.6.2/initial-centre.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let title = format!("title = {}", json!(NASTY));
    let lines = text.lines().map(|line| match line.starts_with("title") {
        true => title.as_str(),
        false => line,
    });
    let mut text: Vec<&str> = lines.collect();
    let who = format!("[title_block]\nprepared = {}", json!(NASTY));
    text.push(&who);
    text.push("# </pre></script><script>window.broken = 2</script><!--");
    let mut case = case::parse(&path.display().to_string(), &text.join("\n")).unwrap();
    case.set_preset("report-like").unwrap();
    case
}

/// The page of that case, made once.
fn page() -> PathBuf {
    static FOLDER: OnceLock<TempDir> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| {
        let folder = tempfile::tempdir().unwrap();
        let options = Options {
            out: Some(folder.path().to_owned()),
            report: true,
            ..Options::default()
        };
        job::run(&nasty_case(), &options, &mut Silent).unwrap();
        folder
    });
    folder.path().join("report.html")
}

fn open() -> Chromium {
    let mut browser = Chromium::open(&page());
    browser.wait_for("document.readyState === 'complete'");
    browser.wait_for("document.querySelector('#view').dataset.ready === 'true'");
    drawn(&mut browser);
    browser
}

/// Waits until whatever was asked for is drawn.
fn drawn(browser: &mut Chromium) {
    let frames =
        "new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))";
    browser.wait_for(frames);
}

/// Sets a control of the view as a user does.
fn set(browser: &mut Chromium, control: &str, property: &str, value: &str) {
    browser.value(&format!(
        "(() => {{ const c = document.querySelector('[data-control=\"{control}\"]'); \
         c.{property} = {value}; \
         for (const kind of ['input', 'change']) c.dispatchEvent(new Event(kind)); }})()"
    ));
    drawn(browser);
}

fn text(browser: &mut Chromium, control: &str) -> String {
    let text = browser.value(&format!(
        "document.querySelector('[data-control=\"{control}\"]').textContent"
    ));
    text.as_str().unwrap().to_owned()
}

fn drag(browser: &mut Chromium, by: [f64; 2]) {
    let [x, y, width, height] = browser.place(CANVAS);
    let middle = [x + 0.5 * width, y + 0.5 * height];
    let held = json!({ "button": "left", "buttons": 1, "clickCount": 1 });
    browser.mouse("mousePressed", middle, held.clone());
    for step in 1..=5 {
        let share = f64::from(step) / 5.0;
        let at = [middle[0] + share * by[0], middle[1] + share * by[1]];
        browser.mouse("mouseMoved", at, held.clone());
    }
    let end = [middle[0] + by[0], middle[1] + by[1]];
    browser.mouse("mouseReleased", end, held);
    drawn(browser);
}

#[test]
fn it_opens_from_disk_without_network_and_without_errors() {
    let mut browser = open();
    drag(&mut browser, [60.0, 20.0]);
    assert_eq!(browser.complaints(), Vec::<String>::new());
    let bytes = std::fs::metadata(page()).unwrap().len();
    assert!(bytes < 5_000_000, "{bytes}");
    let elsewhere = "document.querySelectorAll('[src]:not([src^=\"data:\"]), link:not([href^=\"data:\"])').length";
    assert_eq!(browser.value(elsewhere), json!(0));
}

#[test]
fn what_the_user_writes_is_shown_and_never_obeyed() {
    let mut browser = open();
    assert_eq!(browser.value("window.broken === undefined"), json!(true));
    assert_eq!(
        browser.value("document.querySelector('h1').textContent"),
        json!(NASTY)
    );
    let title = browser.value("document.title");
    assert!(title.as_str().unwrap().starts_with(NASTY), "{title}");
    let echo = browser.value("document.querySelector('pre').textContent");
    assert_eq!(echo.as_str().unwrap(), nasty_case().source.text());
}

#[test]
fn the_view_shows_every_body() {
    let mut browser = open();
    let all = browser.picture(CANVAS);
    let area = all.size[0] * all.size[1];
    assert!(20 * all.coloured() > area, "{} of {area}", all.coloured());
    let boxes = "[...document.querySelectorAll('[data-control=\"bodies\"] input')]";
    assert_eq!(browser.value(&format!("{boxes}.length")), json!(BODIES));
    for body in 0..BODIES {
        browser.value(&format!(
            "{boxes}.forEach((box, k) => {{ if (box.checked !== (k === {body})) box.click(); }})"
        ));
        drawn(&mut browser);
        let one = browser.picture(CANVAS).coloured();
        assert!(one > 2000 && one < all.coloured(), "body {body}: {one}");
    }
}

#[test]
fn the_mouse_turns_moves_and_zooms() {
    let mut browser = open();
    let before = browser.picture(CANVAS);
    drag(&mut browser, [120.0, -40.0]);
    let turned = browser.picture(CANVAS);
    let least = before.coloured() / 5;
    assert!(turned.differs(&before) > least);
    let [x, y, width, height] = browser.place(CANVAS);
    let middle = [x + 0.5 * width, y + 0.5 * height];
    browser.mouse("mouseWheel", middle, json!({ "deltaX": 0, "deltaY": -300 }));
    // The wheel is told to the page when it suits the browser.
    browser.wait_for("view.camera.height < 0.9 * view.size");
    drawn(&mut browser);
    let zoomed = browser.picture(CANVAS);
    assert!(zoomed.coloured() > turned.coloured());
    browser.mouse("mouseMoved", middle, json!({}));
    browser.wait_for("document.querySelector('[data-control=\"told\"]').textContent !== ''");
    let told = text(&mut browser, "told");
    assert!(
        told.contains("Mises stress") && told.contains("ksi"),
        "{told}"
    );
}

#[test]
fn cut_field_and_displacement_change_the_picture() {
    let mut browser = open();
    let before = browser.picture(CANVAS);
    set(&mut browser, "cut", "value", "'0'");
    set(&mut browser, "turned", "checked", "true");
    set(&mut browser, "at", "value", "'0.25'");
    let cut = browser.picture(CANVAS);
    set(&mut browser, "at", "value", "'0.6'");
    let deeper = browser.picture(CANVAS);
    assert!(cut.differs(&before) > 2000 && deeper.differs(&cut) > 2000);
    // The cut faces are filled: where bodies were cut there is colour still.
    assert!(deeper.coloured() > before.coloured() / 4);
    set(&mut browser, "cut", "value", "''");
    assert_eq!(browser.picture(CANVAS).differs(&before), 0);
    set(&mut browser, "field", "value", "'1'");
    assert_eq!(text(&mut browser, "quantity"), "contact pressure, ksi");
    // Bare steel is grey, the strips are not.
    let pressed = browser.picture(CANVAS).coloured();
    assert!(pressed > 20 && pressed < before.coloured() / 2, "{pressed}");
    set(&mut browser, "field", "value", "'0'");
    set(&mut browser, "deform", "value", "'1'");
    assert!(text(&mut browser, "deform-value").ends_with('×'));
    assert!(browser.picture(CANVAS).differs(&before) > 2000);
    assert_eq!(browser.complaints(), Vec::<String>::new());
}

#[test]
fn print_has_pictures_in_place_of_the_view() {
    let mut browser = open();
    browser.value("dispatchEvent(new Event('beforeprint'))");
    browser.wait_for("document.querySelector('#view .still').complete");
    browser.call("Emulation.setEmulatedMedia", json!({ "media": "print" }));
    let shown = |selector: &str| {
        format!("document.querySelector('{selector}').getBoundingClientRect().height > 50")
    };
    assert_eq!(browser.value(&shown(CANVAS)), json!(false));
    assert_eq!(browser.value(&shown("#pictures svg")), json!(true));
    assert_eq!(browser.value(&shown("#view .still")), json!(true));
    let still = browser.picture("#view .still");
    assert!(still.coloured() > 2000, "{}", still.coloured());
    let picture = browser.picture("#pictures svg");
    assert!(picture.coloured() > 2000, "{}", picture.coloured());
    let pdf = browser.call("Page.printToPDF", json!({}));
    assert!(pdf["data"].as_str().unwrap().starts_with("JVBERi0"));
}

/// The title block has what the case says, as text, and a blank for what it does not.
#[test]
fn the_title_block_is_text_and_blanks() {
    let mut browser = open();
    let entry = |name: &str| {
        format!(
            "[...document.querySelectorAll('.title-block div')] \
             .find(d => d.querySelector('dt').textContent === '{name}') \
             .querySelector('dd').textContent"
        )
    };
    assert_eq!(browser.value(&entry("prepared")), json!(NASTY));
    assert_eq!(browser.value(&entry("checked")), json!(""));
    let hash = browser.value(&entry("case file, FNV-1a"));
    assert_eq!(hash.as_str().map(str::len), Some(16));
}

/// Sizes of paper in points, as the printed file has them.
#[test]
fn the_page_is_printed_on_the_paper_that_is_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(page(), folder.path().join("report.html")).unwrap();
    for (paper, size) in [("a4", [595.0, 842.0]), ("letter", [612.0, 792.0])] {
        let run = std::process::Command::new(env!("CARGO_BIN_EXE_brinell"))
            .args(["report", "--pdf", "--paper", paper])
            .arg(folder.path())
            .output()
            .unwrap();
        assert!(
            run.status.success(),
            "{}",
            String::from_utf8_lossy(&run.stderr)
        );
        let pdf = std::fs::read(folder.path().join("report.pdf")).unwrap();
        let pdf = String::from_utf8_lossy(&pdf).into_owned();
        let boxes: Vec<Vec<f64>> = (pdf.split("/MediaBox [").skip(1))
            .filter_map(|rest| rest.split(']').next())
            .map(|text| {
                text.split_whitespace()
                    .filter_map(|n| n.parse().ok())
                    .collect()
            })
            .collect();
        assert!(boxes.len() > 2, "{} pages", boxes.len());
        for sides in boxes {
            assert!(
                (sides[2] - size[0]).abs() < 1.0 && (sides[3] - size[1]).abs() < 1.0,
                "{sides:?}"
            );
        }
    }
    let empty = tempfile::tempdir().unwrap();
    let run = std::process::Command::new(env!("CARGO_BIN_EXE_brinell"))
        .args(["report", "--pdf"])
        .arg(empty.path())
        .output()
        .unwrap();
    assert_eq!(run.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&run.stderr).contains("no page of a run"));
}
