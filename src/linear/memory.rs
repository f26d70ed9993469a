//! What memory is left, and what was taken.

use std::fs;

/// Bytes that this process can still get, as far as the system tells: what the machine has left, or
/// less where a control group says so.
pub fn available() -> Option<f64> {
    let machine = fs::read_to_string("/proc/meminfo").ok();
    let machine = machine
        .as_deref()
        .and_then(|text| bytes(text, "MemAvailable:"));
    let machine = machine.map(|bytes| bytes as f64);
    let group = |name: &str| -> Option<f64> {
        let text = fs::read_to_string(format!("/sys/fs/cgroup/memory.{name}")).ok()?;
        text.trim().parse().ok()
    };
    let group = group("max").zip(group("current")).map(|(m, c)| m - c);
    match (machine, group) {
        (Some(machine), Some(group)) => Some(machine.min(group)),
        (machine, group) => machine.or(group),
    }
}

/// Largest resident memory of this process so far, in bytes, where the system tells.
pub fn peak() -> Option<u64> {
    bytes(&fs::read_to_string("/proc/self/status").ok()?, "VmHWM:")
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
    }
}
