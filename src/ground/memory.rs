//! What memory is left, and what was taken.

use std::fs;
use std::path::{Path, PathBuf};

/// Prefix of the kernel's files, for tests: a folder that has `proc` and `sys` below it.
const SYSTEM_ROOT_VARIABLE: &str = "BRINELL_SYSTEM_ROOT";

/// Address space, in bytes, that each thread reserves for its stack and an arena of the allocator.
const STACK_AND_ARENA: f64 = 80e6;

/// Bytes that this process can still get, as far as the system tells: what the machine has left, or
/// less where a control group, its parents or a limit on the address space (`ulimit -v`) say so.
pub fn available() -> Option<f64> {
    let root = root();
    let read = |path: &str| fs::read_to_string(root.join(path)).ok();
    let machine = read("proc/meminfo").and_then(|text| bytes(&text, "MemAvailable:"));
    let threads = 1 + rayon::current_num_threads();
    let space = read("proc/self/limits").and_then(|text| address_space(&text));
    let taken = read("proc/self/status").and_then(|text| {
        let [size, resident] = ["VmSize:", "VmRSS:"].map(|name| bytes(&text, name));
        Some([size? as f64, resident? as f64])
    });
    let left = [
        machine.map(|bytes| bytes as f64),
        read("proc/self/cgroup").and_then(|text| groups(&text, &root)),
        space.zip(taken).map(|(space, [size, resident])| {
            // What is reserved without being used is what some of the threads have reserved already.
            let reserved = (size - resident).max(threads as f64 * of_a_thread(&read));
            (space as f64 - resident - reserved).max(0.0)
        }),
    ];
    left.into_iter().flatten().reduce(f64::min)
}

/// The threads beside the first that may reserve half of the address space, where that has a limit: one at least.
pub fn most_threads() -> Option<usize> {
    let root = root();
    let read = |path: &str| fs::read_to_string(root.join(path)).ok();
    let space = address_space(&read("proc/self/limits")?)?;
    let threads = 0.5 * space as f64 / of_a_thread(&read) - 1.0;
    Some((threads as usize).max(1))
}

fn root() -> PathBuf {
    std::env::var_os(SYSTEM_ROOT_VARIABLE).map_or_else(|| PathBuf::from("/"), PathBuf::from)
}

/// Address space that a thread reserves: the kernel of dense products takes two buffers of the size of the last level
/// of cache in every thread, and touches next to nothing of them.
fn of_a_thread(read: &impl Fn(&str) -> Option<String>) -> f64 {
    STACK_AND_ARENA + 2.0 * last_cache(read).unwrap_or(0.0)
}

/// Bytes of the last level of cache, of all processors together.
fn last_cache(read: &impl Fn(&str) -> Option<String>) -> Option<f64> {
    let folder = "sys/devices/system/cpu";
    let text = read(&format!("{folder}/cpu0/cache/index3/size"))?;
    let kib: f64 = text.trim().strip_suffix('K')?.parse().ok()?;
    let shared = read(&format!("{folder}/cpu0/cache/index3/shared_cpu_list"));
    let [sharing, all] = [shared, read(&format!("{folder}/present"))].map(|text| {
        text.as_deref()
            .and_then(processors)
            .filter(|count| *count > 0.0)
    });
    let caches = all.zip(sharing).map_or(1.0, |(all, sharing)| all / sharing);
    Some(1024.0 * kib * caches.max(1.0))
}

/// How many there are in a list of the kernel, such as `0-3,8`.
fn processors(list: &str) -> Option<f64> {
    let count = |range: &str| -> Option<f64> {
        let (first, last) = range.split_once('-').unwrap_or((range, range));
        Some(last.parse::<f64>().ok()? - first.parse::<f64>().ok()? + 1.0)
    };
    list.trim().split(',').map(count).sum()
}

/// What the control groups of this process, as `/proc/self/cgroup` lists them, and their parents leave it: version
/// 2 (an empty list of controllers) and version 1.
fn groups(list: &str, root: &Path) -> Option<f64> {
    let left = list.lines().flat_map(|line| {
        let mut parts = line.splitn(3, ':').skip(1);
        let (controllers, path) = (parts.next().unwrap_or(""), parts.next().unwrap_or("/"));
        let version = match controllers {
            "" => Some(("sys/fs/cgroup", ["memory.max", "memory.current"], "")),
            _ if controllers.split(',').any(|c| c == "memory") => Some((
                "sys/fs/cgroup/memory",
                ["memory.limit_in_bytes", "memory.usage_in_bytes"],
                "total_",
            )),
            _ => None,
        };
        // A container may see its own group as the root of all, whatever the list says.
        let folders = Path::new(path.trim_start_matches('/')).ancestors();
        let left = |(base, files, prefix): (&str, [&str; 2], &str)| {
            let in_folder = |folder: &Path| of_group(&root.join(base).join(folder), files, prefix);
            folders.filter_map(in_folder).reduce(f64::min)
        };
        version.and_then(left)
    });
    left.reduce(f64::min)
}

/// What one control group leaves. The page cache is given back when it is needed, and does not count as taken.
fn of_group(folder: &Path, [limit, usage]: [&str; 2], prefix: &str) -> Option<f64> {
    /// Version 1 writes a number beyond all memory where there is no limit.
    const NONE: f64 = 1e18;
    let read = |name: &str| fs::read_to_string(folder.join(name)).ok();
    let number = |name: &str| read(name)?.trim().parse::<f64>().ok();
    let limit = number(limit).filter(|limit| *limit < NONE)?;
    let stat = read("memory.stat").unwrap_or_default();
    let cache = stat.lines().filter_map(|line| {
        let (name, value) = line.split_once(' ')?;
        let name = name.strip_prefix(prefix)?;
        let counts = name == "active_file" || name == "inactive_file";
        counts.then(|| value.trim().parse::<f64>().ok())?
    });
    let taken = number(usage).unwrap_or(0.0) - cache.sum::<f64>();
    Some((limit - taken.max(0.0)).max(0.0))
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

    fn kernel(files: &[(&str, &str)]) -> tempfile::TempDir {
        let root = tempfile::tempdir().unwrap();
        for (name, text) in files {
            let path = root.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        root
    }

    #[test]
    fn the_narrowest_of_nested_groups_counts() {
        let root = kernel(&[
            ("sys/fs/cgroup/memory.max", "max\n"),
            ("sys/fs/cgroup/a/memory.max", "3000\n"),
            ("sys/fs/cgroup/a/memory.current", "1500\n"),
            (
                "sys/fs/cgroup/a/memory.stat",
                "anon 1\nactive_file 200\ninactive_file 300\n",
            ),
            ("sys/fs/cgroup/a/b/memory.max", "5000\n"),
            ("sys/fs/cgroup/a/b/memory.current", "400\n"),
        ]);
        assert_eq!(groups("0::/a/b\n", root.path()), Some(2000.0));
        assert_eq!(groups("0::/\n", root.path()), None);
        // A group that is not mounted under its own name.
        assert_eq!(groups("0::/elsewhere\n", root.path()), None);
    }

    #[test]
    fn the_first_version_of_groups_is_read_too() {
        let folder = "sys/fs/cgroup/memory/job";
        let file = |name: &str| format!("{folder}/{name}");
        let root = kernel(&[
            (&file("memory.limit_in_bytes"), "3000\n"),
            (&file("memory.usage_in_bytes"), "1000\n"),
            (
                &file("memory.stat"),
                "active_file 7\ntotal_inactive_file 100\n",
            ),
            (
                "sys/fs/cgroup/memory/memory.limit_in_bytes",
                "9223372036854771712\n",
            ),
        ]);
        let list = "7:cpu,cpuacct:/x\n4:memory:/job\n0::/\n";
        assert_eq!(groups(list, root.path()), Some(2100.0));
    }

    #[test]
    fn caches_of_all_processors_count() {
        let read = |path: &str| {
            let name = path.rsplit('/').next().unwrap_or("");
            let text = match name {
                "size" => "32768K\n",
                "shared_cpu_list" => "0-3,16-19\n",
                _ => "0-31\n",
            };
            Some(text.to_owned())
        };
        assert_eq!(last_cache(&read), Some(4.0 * 32.0 * 1024.0 * 1024.0));
        assert_eq!(last_cache(&|_: &str| None), None);
        assert_eq!(processors("0-3,8\n"), Some(5.0));
        assert_eq!(processors("\n"), None);
    }

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
