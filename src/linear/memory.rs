//! What memory is left, and what was taken.

use std::fs;

/// Bytes that this process can still get, as far as the system tells: what the machine has left, or
/// less where a control group or a limit on the address space (`ulimit -v`) says so.
pub fn available() -> Option<f64> {
    let read = |path: &str| fs::read_to_string(path).ok();
    let machine = read("/proc/meminfo").and_then(|text| bytes(&text, "MemAvailable:"));
    let group = |name: &str| -> Option<f64> {
        let text = read(&format!("/sys/fs/cgroup/memory.{name}"))?;
        text.trim().parse().ok()
    };
    let space = read("/proc/self/limits").and_then(|text| address_space(&text));
    let taken = read("/proc/self/status").and_then(|text| bytes(&text, "VmSize:"));
    let left = [
        machine.map(|bytes| bytes as f64),
        group("max").zip(group("current")).map(|(m, c)| m - c),
        space.zip(taken).map(|(s, t)| s.saturating_sub(t) as f64),
    ];
    left.into_iter().flatten().reduce(f64::min)
}

/// Largest resident memory of this process so far, in bytes, where the system tells.
pub fn peak() -> Option<u64> {
    bytes(&fs::read_to_string("/proc/self/status").ok()?, "VmHWM:")
}

/// The soft limit on the address space in the kernel's table of limits, in bytes; `None` where there is
/// none.
fn address_space(text: &str) -> Option<u64> {
    const NAME: &str = "Max address space";
    let line = text.lines().find_map(|l| l.strip_prefix(NAME))?;
    line.split_whitespace().next()?.parse().ok()
}

/// The entry `name` of a table of the kernel, in bytes.
fn bytes(text: &str, name: &str) -> Option<u64> {
    let line = text.lines().find(|l| l.starts_with(name))?;
    let kib: u64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024 * kib)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_kernel_writes_is_read() {
        let text = "MemTotal:       24689764 kB\nMemAvailable:   1024 kB\n";
        assert_eq!(bytes(text, "MemAvailable:"), Some(1_048_576));
        assert_eq!(bytes("MemTotal: 1 kB\n", "MemAvailable:"), None);
        let text = "Max open files      20000     20000     files\n\
                    Max address space   1048576   unlimited bytes\n";
        assert_eq!(address_space(text), Some(1_048_576));
        assert_eq!(address_space(&text.replace("1048576", "unlimited")), None);
    }
}
