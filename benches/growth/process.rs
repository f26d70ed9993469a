//! A child process with a time limit, and what it used.

use std::fs::File;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

/// What a process used.
#[derive(Debug, Clone, Copy)]
pub struct Usage {
    pub wall_s: f64,
    /// User and system, of all threads, and of its own children that it waited for.
    pub cpu_s: f64,
    pub peak_memory_bytes: u64,
}

/// How a process came to its end.
#[derive(Debug, Clone, PartialEq)]
pub enum End {
    Exit(i32),
    Signal(i32),
    /// It was stopped at the limit.
    Limit,
}

/// Runs `command` no longer than `limit`; what it prints goes to the file `log`.
pub fn run(command: &mut Command, log: &Path, limit: Duration) -> io::Result<(End, Usage)> {
    let start = Instant::now();
    let output = File::create(log)?;
    let mut child = command
        .stdin(Stdio::null())
        .stdout(output.try_clone()?)
        .stderr(output)
        .spawn()?;
    let id = libc::pid_t::try_from(child.id()).map_err(io::Error::other)?;
    let mut stopped = false;
    loop {
        if let Some((status, usage)) = wait(id)? {
            let end = if stopped {
                End::Limit
            } else if libc::WIFSIGNALED(status) {
                End::Signal(libc::WTERMSIG(status))
            } else {
                End::Exit(libc::WEXITSTATUS(status))
            };
            let seconds = |t: libc::timeval| t.tv_sec as f64 + 1e-6 * t.tv_usec as f64;
            let usage = Usage {
                wall_s: start.elapsed().as_secs_f64(),
                cpu_s: seconds(usage.ru_utime) + seconds(usage.ru_stime),
                // Linux counts in KiB.
                peak_memory_bytes: 1024 * usage.ru_maxrss as u64,
            };
            return Ok((end, usage));
        }
        if !stopped && start.elapsed() > limit {
            child.kill()?;
            stopped = true;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// Status and usage of a child that has ended.
fn wait(id: libc::pid_t) -> io::Result<Option<(libc::c_int, libc::rusage)>> {
    let mut status = 0;
    let mut usage = std::mem::MaybeUninit::<libc::rusage>::zeroed();
    // SAFETY: both pointers are to live variables of the types that the call fills; all zeros are
    // a valid `rusage`.
    let (ended, usage) = unsafe {
        let ended = libc::wait4(id, &mut status, libc::WNOHANG, usage.as_mut_ptr());
        (ended, usage.assume_init())
    };
    match ended {
        0 => Ok(None),
        -1 => Err(io::Error::last_os_error()),
        _ => Ok(Some((status, usage))),
    }
}
