//! A child process with what it cost: time on the clock, of the processor, and largest memory.

use std::fs::File;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Instant;

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
    let (status, usage) = wait(child.id()).map_err(failed)?;
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
        // Linux counts in KiB.
        peak_mb: usage.ru_maxrss as f64 * 1024e-6,
    })
}

/// Waits for a child: its exit status (or 128 and the signal) and the resources it used.
fn wait(id: u32) -> std::io::Result<(i32, libc::rusage)> {
    let mut status = 0;
    // SAFETY: plain numbers, for which all zeros is a value.
    let mut usage: libc::rusage = unsafe { std::mem::zeroed() };
    // SAFETY: both pointers are to live variables of the right type.
    let done = unsafe { libc::wait4(id as libc::pid_t, &mut status, 0, &mut usage) };
    if done < 0 {
        return Err(std::io::Error::last_os_error());
    }
    let code = match libc::WIFEXITED(status) {
        true => libc::WEXITSTATUS(status),
        false => 128 + libc::WTERMSIG(status),
    };
    Ok((code, usage))
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
