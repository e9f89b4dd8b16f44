//! The memory that is available to this process, as reported by the operating system.

use std::io;
use std::path::Path;

use loosepin_files::read_named_text;

/// Fallback if the operating system does not report the available memory.
pub const STATED_BYTES: u64 = 16 << 30;
/// From this limit of the address space on, the command lets the C library reserve more than one arena.
const ARENAS_FROM_BYTES: u64 = 1 << 30;
/// Address space that glibc reserves for the allocations of a thread (an arena), bytes.
pub const ARENA_BYTES: u64 = 64 << 20;
/// Reciprocal share of a limited address space that may be reserved for arenas.
pub const ARENAS_PART: u64 = 8;
/// Most arenas.
pub const MAX_ARENAS: u64 = 64;

/// A kind of memory that a study takes, each with a limit of its own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MemoryKind {
    /// Pages that are in use: of the machine, or of the group of the process (a container).
    Pages,
    /// Memory that the process may write, used or not (`ulimit -d`): stacks of threads count in full.
    Data,
    /// Addresses of the process (`ulimit -v`): stacks count in full, and files that are read as memory.
    Addresses,
}

/// Available memory of each kind for the process, bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct MemoryAtHand {
    /// Available [`MemoryKind::Pages`]; [`STATED_BYTES`] if the system does not report it, as outside of Linux.
    pub pages_bytes: u64,
    /// Of [`MemoryKind::Data`], where that is limited.
    pub data_bytes: Option<u64>,
    /// Of [`MemoryKind::Addresses`], where that is limited.
    pub addresses_bytes: Option<u64>,
}

impl MemoryAtHand {
    /// The current value from the operating system.
    pub fn now() -> Self {
        let unlimited = Self { pages_bytes: STATED_BYTES, data_bytes: None, addresses_bytes: None };
        Self::from_system(Path::new("/")).unwrap_or(unlimited)
    }

    /// Available memory as Linux reports it in the files below `root`.
    fn from_system(root: &Path) -> Option<Self> {
        let machine = kibibytes_after(&read_to_string(root.join("proc/meminfo")).ok()?, "MemAvailable:")?;
        let [data_bytes, addresses_bytes] =
            [("Max data size", "VmData:"), ("Max address space", "VmSize:")].map(|keys| of_process(root, keys));
        let pages_bytes = of_groups(root).map_or(machine, |groups| groups.min(machine));
        // The allocations of threads are in parts of the address space of their own, which are reserved in advance. The command
        // bounds them by this share where the limit is so large that it allows several.
        let left = |(limit, left): (u64, u64)| {
            let reserved =
                if limit < ARENAS_FROM_BYTES { 0 } else { (limit / ARENAS_PART).min(MAX_ARENAS * ARENA_BYTES) };
            left.saturating_sub(reserved)
        };
        let (data_bytes, addresses_bytes) = (data_bytes.map(|(_, left)| left), addresses_bytes.map(left));
        Some(Self { pages_bytes, data_bytes, addresses_bytes })
    }

    /// Available memory of `kind`, if it is limited.
    pub fn bytes_of(&self, kind: MemoryKind) -> Option<u64> {
        match kind {
            MemoryKind::Pages => Some(self.pages_bytes),
            MemoryKind::Data => self.data_bytes,
            MemoryKind::Addresses => self.addresses_bytes,
        }
    }
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

/// A limit of the process, and what it leaves: its name in `limits`, and that of what is taken in `status`.
fn of_process(root: &Path, (limit, taken): (&str, &str)) -> Option<(u64, u64)> {
    let limits = read_to_string(root.join("proc/self/limits")).ok()?;
    let line = limits.lines().find_map(|line| line.strip_prefix(limit))?;
    let limit = line.split_whitespace().next()?.parse::<u64>().ok()?;
    let taken = kibibytes_after(&read_to_string(root.join("proc/self/status")).ok()?, taken)?;
    Some((limit, limit.saturating_sub(taken)))
}

/// A text of the system.
fn read_to_string(path: impl AsRef<Path>) -> io::Result<String> {
    const MAX_BYTES: u64 = 1 << 20;
    read_named_text(path.as_ref(), MAX_BYTES)
}

#[cfg(test)]
mod tests {
    use super::MemoryAtHand;
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

    fn pages_bytes(root: &Path) -> Option<u64> {
        MemoryAtHand::from_system(root).map(|at_hand| at_hand.pages_bytes)
    }

    const MACHINE: (&str, &str) = ("proc/meminfo", "MemTotal:  9000 kB\nMemAvailable:    5000 kB\n");
    const UNLIMITED: (&str, &str) =
        ("proc/self/limits", "Max address space         unlimited            unlimited            bytes\n");

    #[test]
    fn a_machine_without_limits_has_what_is_available() {
        let root = machine("plain", &[MACHINE, UNLIMITED, ("proc/self/cgroup", "0::/user\n")]);
        let unlimited = MemoryAtHand { pages_bytes: 5000 * 1024, data_bytes: None, addresses_bytes: None };
        assert_eq!(MemoryAtHand::from_system(&root), Some(unlimited));
        assert_eq!(MemoryAtHand::from_system(Path::new("/nowhere")), None);
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
        assert_eq!(pages_bytes(&machine("two", &groups)), Some(1_000_000 - 250_000));
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
        assert_eq!(pages_bytes(&machine("one", &groups)), Some(200_000));
    }

    #[test]
    fn limits_of_the_process_count() {
        let process = |addresses: u64| {
            let limits = format!(
                "Max data size             2000000              unlimited            bytes\n\
                 Max address space         {addresses}              unlimited            bytes\n"
            );
            let status = "VmPeak:\t 2000 kB\nVmSize:\t 1000 kB\nVmData:\t 500 kB\n";
            let files = [MACHINE, ("proc/self/limits", &limits), ("proc/self/status", status)];
            MemoryAtHand::from_system(&machine("process", &files))
        };
        let expected = |addresses_bytes| MemoryAtHand {
            pages_bytes: 5000 * 1024,
            data_bytes: Some(2_000_000 - 512_000),
            addresses_bytes: Some(addresses_bytes),
        };
        assert_eq!(process(3_000_000), Some(expected(3_000_000 - 1_024_000)));
        // An eighth is reserved for the allocations of threads.
        assert_eq!(process(8 << 30), Some(expected((7 << 30) - 1_024_000)));
    }

    #[test]
    fn this_machine_has_some() {
        assert!(MemoryAtHand::now().pages_bytes > 1 << 20);
    }
}
