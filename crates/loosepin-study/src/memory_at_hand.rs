//! The memory that this process may still take, as the operating system tells it.

use std::io;
use std::path::Path;

use loosepin_files::read_named;

/// Where no operating system tells, so much is taken to be there.
pub const STATED_BYTES: u64 = 16 << 30;

/// What the process may still take, bytes: what the machine has available, and no more than its group of processes (a container)
/// and its own limit of address space leave. [`STATED_BYTES`] where the system does not tell, as outside of Linux.
pub fn memory_at_hand_bytes() -> u64 {
    told_bytes(Path::new("/")).unwrap_or(STATED_BYTES)
}

/// As Linux tells it in the files below `root`.
fn told_bytes(root: &Path) -> Option<u64> {
    let machine = kibibytes_after(&read_to_string(root.join("proc/meminfo")).ok()?, "MemAvailable:")?;
    let limits = [of_groups(root), of_process(root)];
    Some(limits.into_iter().flatten().fold(machine, u64::min))
}

/// The number of kibibytes in the line that begins with `key`, in bytes.
fn kibibytes_after(text: &str, key: &str) -> Option<u64> {
    let line = text.lines().find_map(|line| line.strip_prefix(key))?;
    line.split_whitespace().next()?.parse::<u64>().ok()?.checked_mul(1024)
}

/// What the groups of the process leave, the narrowest of all those that hold it.
fn of_groups(root: &Path) -> Option<u64> {
    let groups = read_to_string(root.join("proc/self/cgroup")).ok()?;
    let of_line = |line: &str| {
        let mut fields = line.splitn(3, ':').skip(1);
        let (controllers, path) = (fields.next()?, fields.next()?);
        // Version 2 has one hierarchy without names; of version 1 that of the memory counts.
        let (folder, limit, used, file) = if controllers.is_empty() {
            ("sys/fs/cgroup", "memory.max", "memory.current", "inactive_file ")
        } else if controllers.split(',').any(|controller| controller == "memory") {
            ("sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file ")
        } else {
            return None;
        };
        let number = |path: &Path| read_to_string(path).ok()?.trim().parse::<u64>().ok();
        let left = |group: &Path| {
            let (limit, used) = (number(&group.join(limit))?, number(&group.join(used))?);
            // Files that were read and are not in use give their memory back.
            let stat = read_to_string(group.join("memory.stat")).unwrap_or_default();
            let kept = stat.lines().find_map(|line| line.strip_prefix(file)?.trim().parse::<u64>().ok());
            Some(limit.saturating_sub(used.saturating_sub(kept.unwrap_or(0))))
        };
        let top = root.join(folder);
        let own = top.join(path.trim_start_matches('/'));
        own.ancestors().take_while(|group| group.starts_with(&top)).filter_map(left).min()
    };
    groups.lines().filter_map(of_line).min()
}

/// What the limit of the address space leaves (`ulimit -v`).
fn of_process(root: &Path) -> Option<u64> {
    let limits = read_to_string(root.join("proc/self/limits")).ok()?;
    let line = limits.lines().find_map(|line| line.strip_prefix("Max address space"))?;
    let limit = line.split_whitespace().next()?.parse::<u64>().ok()?;
    let taken = kibibytes_after(&read_to_string(root.join("proc/self/status")).ok()?, "VmSize:")?;
    Some(limit.saturating_sub(taken))
}

/// A text of the system.
fn read_to_string(path: impl AsRef<Path>) -> io::Result<String> {
    const MAX_BYTES: u64 = 1 << 20;
    let bytes = read_named(path.as_ref(), MAX_BYTES)?;
    String::from_utf8(bytes).map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))
}

#[cfg(test)]
mod tests {
    use super::{memory_at_hand_bytes, told_bytes};
    use std::path::{Path, PathBuf};

    /// A made-up machine: files and their texts.
    fn machine(name: &str, files: &[(&str, &str)]) -> PathBuf {
        let root = std::env::temp_dir().join(format!("loosepin-memory-{}-{name}", std::process::id()));
        for (path, text) in files {
            let path = root.join(path);
            path.parent().map(std::fs::create_dir_all).transpose().expect("a folder");
            std::fs::write(path, text).expect("a file");
        }
        root
    }

    const MACHINE: (&str, &str) = ("proc/meminfo", "MemTotal:  9000 kB\nMemAvailable:    5000 kB\n");
    const UNLIMITED: (&str, &str) =
        ("proc/self/limits", "Max address space         unlimited            unlimited            bytes\n");

    #[test]
    fn a_machine_without_limits_has_what_is_available() {
        let root = machine("plain", &[MACHINE, UNLIMITED, ("proc/self/cgroup", "0::/user\n")]);
        assert_eq!(told_bytes(&root), Some(5000 * 1024));
        assert_eq!(told_bytes(Path::new("/nowhere")), None);
    }

    #[test]
    fn the_narrowest_group_of_version_2_counts() {
        let groups = [
            MACHINE,
            ("proc/self/cgroup", "0::/a/b\n"),
            ("sys/fs/cgroup/a/memory.max", "1000000\n"),
            ("sys/fs/cgroup/a/memory.current", "400000\n"),
            ("sys/fs/cgroup/a/memory.stat", "anon 1\ninactive_file 150000\n"),
            ("sys/fs/cgroup/a/b/memory.max", "max\n"),
            ("sys/fs/cgroup/a/b/memory.current", "300000\n"),
        ];
        assert_eq!(told_bytes(&machine("two", &groups)), Some(1_000_000 - 250_000));
    }

    #[test]
    fn a_group_of_version_1_counts_that_a_container_sees_at_the_top() {
        let groups = [
            MACHINE,
            ("proc/self/cgroup", "5:cpu:/docker/x\n4:memory:/docker/x\n"),
            ("sys/fs/cgroup/memory/memory.limit_in_bytes", "2000000\n"),
            ("sys/fs/cgroup/memory/memory.usage_in_bytes", "2500000\n"),
            ("sys/fs/cgroup/memory/memory.stat", "total_inactive_file 700000\n"),
        ];
        assert_eq!(told_bytes(&machine("one", &groups)), Some(200_000));
    }

    #[test]
    fn a_limit_of_the_address_space_counts() {
        let process = [
            MACHINE,
            ("proc/self/limits", "Max address space         3000000              unlimited            bytes\n"),
            ("proc/self/status", "VmPeak:\t 2000 kB\nVmSize:\t 1000 kB\n"),
        ];
        assert_eq!(told_bytes(&machine("process", &process)), Some(3_000_000 - 1_024_000));
    }

    #[test]
    fn this_machine_has_some() {
        assert!(memory_at_hand_bytes() > 1 << 20);
    }
}
