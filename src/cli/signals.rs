//! The end of a command by Ctrl-C or by the system.

use super::status::ExitStatus;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// A flag that Ctrl-C (SIGINT) and the end of a job's time (SIGTERM) set; a second one ends the program at once.
pub fn set_on_ctrl_c() -> Arc<AtomicBool> {
    let stop = Arc::new(AtomicBool::new(false));
    for signal in [SIGINT, SIGTERM] {
        let end = i32::from(ExitStatus::Interrupted as u8);
        // In this order: the first signal finds the flag down.
        let ends = flag::register_conditional_shutdown(signal, end, Arc::clone(&stop));
        // Where the system refuses, signals do as they always do.
        let _ = ends.and_then(|_| flag::register(signal, Arc::clone(&stop)));
    }
    stop
}
