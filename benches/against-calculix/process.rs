//! A child process with what it cost: time on the clock, of the processor, and largest memory.

use std::fs::File;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What a process cost.
#[derive(Debug, Clone, Copy, Default)]
pub struct Cost {
    pub wall_s: f64,
    /// User and system time of all its threads.
    pub cpu_s: f64,
    pub peak_mb: f64,
}

/// Runs `command`, its output going to the file `log`.
///
/// # Errors
/// Where it cannot be started, or fails; the message ends with the end of its output.
pub fn run(command: &mut Command, log: &Path) -> Result<Cost, String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let failed = |error: std::io::Error| format!("{name}: {error}");
    let file = File::create(log).map_err(failed)?;
    let errors = file.try_clone().map_err(failed)?;
    let clock = Instant::now();
    command.stdin(Stdio::null()).stdout(file).stderr(errors);
    let child = command.spawn().map_err(failed)?;
    let mut peak_kib = 0;
    let (status, usage) = loop {
        peak_kib = peak_kib.max(peak(child.id()));
        if let Some(ended) = ended(child.id()).map_err(failed)? {
            break ended;
        }
        // Seldom enough to cost nothing, and often enough to miss nothing of a short run.
        let pause = (0.01 * clock.elapsed().as_secs_f64()).clamp(1e-3, 0.05);
        std::thread::sleep(Duration::from_secs_f64(pause));
    };
    let wall_s = clock.elapsed().as_secs_f64();
    if status != 0 {
        let text = std::fs::read_to_string(log).unwrap_or_default();
        let lines: Vec<&str> = text.lines().collect();
        let end = lines[lines.len().saturating_sub(12)..].join("\n");
        return Err(format!("{name} ended with status {status}:\n{end}"));
    }
    let seconds = |time: libc::timeval| time.tv_sec as f64 + 1e-6 * time.tv_usec as f64;
    Ok(Cost {
        wall_s,
        cpu_s: seconds(usage.ru_utime) + seconds(usage.ru_stime),
        peak_mb: 1024e-6 * peak_kib as f64,
    })
}

/// Largest resident memory of a running process so far, KiB. The one that the system tells at the
/// end is not asked: it counts the memory of the process that started it.
fn peak(id: u32) -> u64 {
    let status = std::fs::read_to_string(format!("/proc/{id}/status")).unwrap_or_default();
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"));
    line.and_then(|l| l.split_whitespace().next()?.parse().ok())
        .unwrap_or(0)
}

/// Has a child ended? Its exit status (or 128 and the signal) and the resources it used.
fn ended(id: u32) -> std::io::Result<Option<(i32, libc::rusage)>> {
    let mut status = 0;
    // SAFETY: plain numbers, for which all zeros is a value.
    let mut usage: libc::rusage = unsafe { std::mem::zeroed() };
    // SAFETY: both pointers are to live variables of the right type.
    let done = unsafe { libc::wait4(id as libc::pid_t, &mut status, libc::WNOHANG, &mut usage) };
    match done {
        0 => return Ok(None),
        d if d < 0 => return Err(std::io::Error::last_os_error()),
        _ => {}
    }
    let code = match libc::WIFEXITED(status) {
        true => libc::WEXITSTATUS(status),
        false => 128 + libc::WTERMSIG(status),
    };
    Ok(Some((code, usage)))
}

/// The run of median time of the processor, of `times` runs.
///
/// # Errors
/// Those of the first run that fails.
pub fn median(times: usize, mut run: impl FnMut() -> Result<Cost, String>) -> Result<Cost, String> {
    let mut costs = (0..times.max(1))
        .map(|_| run())
        .collect::<Result<Vec<_>, _>>()?;
    costs.sort_by(|a, b| a.cpu_s.total_cmp(&b.cpu_s));
    Ok(costs[costs.len() / 2])
}
