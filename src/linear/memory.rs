//! What memory is left.

use std::fs;

/// Bytes that this process can still get, as far as the system tells: what the machine has left, or
/// less where a control group says so.
pub fn available() -> Option<f64> {
    let machine = fs::read_to_string("/proc/meminfo").ok();
    let machine = machine.as_deref().and_then(machine_has_left);
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

/// `MemAvailable` of `/proc/meminfo`, in bytes.
fn machine_has_left(text: &str) -> Option<f64> {
    let line = text.lines().find(|l| l.starts_with("MemAvailable:"))?;
    let kib: f64 = line.split_whitespace().nth(1)?.parse().ok()?;
    Some(1024.0 * kib)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_kernel_writes_is_read() {
        let text = "MemTotal:       24689764 kB\nMemAvailable:   1024 kB\n";
        assert_eq!(machine_has_left(text), Some(1_048_576.0));
        assert_eq!(machine_has_left("MemTotal: 1 kB\n"), None);
    }
}
