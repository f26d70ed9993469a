//! Threads of a command.

use crate::ground::memory;
use std::io::Write;

/// Sets the size of the thread pool, smaller where the address space has a limit; a pool that exists already is kept.
pub fn set_threads(threads: Option<u16>) {
    let set = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let _ = pool.build_global();
    };
    let by_default = || {
        let named = std::env::var("RAYON_NUM_THREADS").ok();
        let named = named.and_then(|text| text.parse().ok());
        named.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from))
    };
    let asked = threads.map_or_else(by_default, usize::from);
    match memory::most_threads() {
        Some(most) if most < asked => {
            // A closed pipe is no reason to end.
            let _ = writeln!(
                std::io::stderr(),
                "threads: {most} in place of {asked}, as the address space is limited"
            );
            set(most);
        }
        _ if threads.is_some() => set(asked),
        _ => {}
    }
}
