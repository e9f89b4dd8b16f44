//! One writer for each folder of results.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use loosepin_text::date::date;

use super::error::ResultsError;

/// Name of the file that is locked while somebody writes into a folder of results. It says who that is.
pub const LOCK_FILE: &str = "loosepin.lock";

/// The right to write into a folder of results, held by one process at a time.
///
/// The operating system gives the lock back when its holder ends, however that happens. A file that is left behind therefore
/// says nothing.
#[derive(Debug)]
pub struct FolderLock {
    path: PathBuf,
    file: File,
    /// Folders that were made for the lock, the innermost first.
    made: Vec<PathBuf>,
}

impl FolderLock {
    /// Takes the folder, making it where there is none; `work` says to others what it is taken for.
    ///
    /// # Errors
    /// Another process holds it; the file system refuses, or has no locks.
    pub fn take(folder: &Path, work: &str) -> Result<Self, ResultsError> {
        let path = folder.join(LOCK_FILE);
        let refused = |source: io::Error| ResultsError::Write { path: path.clone(), source };
        // Whoever had the lock until now may remove its file, and a folder that was made for it, at any moment.
        const MOST_TRIES: usize = 100;
        for _ in 0..MOST_TRIES {
            let made: Vec<PathBuf> =
                folder.ancestors().take_while(|folder| !folder.exists()).map(Path::to_owned).collect();
            let opened = fs::create_dir_all(folder)
                .and_then(|()| OpenOptions::new().read(true).write(true).create(true).truncate(false).open(&path));
            let file = match opened {
                Ok(file) => file,
                Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
                // The folder was there when it was to be made, and gone when it was looked at.
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists && !is_no_folder(folder) => continue,
                Err(error) => {
                    remove_empty(&made);
                    return Err(refused(error));
                }
            };
            match file.try_lock() {
                Ok(()) if is_at(&file, &path) => {
                    let mut lock = Self { path: path.clone(), file, made };
                    lock.name_holder(work).map_err(refused)?;
                    return Ok(lock);
                }
                Ok(()) => continue,
                Err(TryLockError::WouldBlock) => {
                    return Err(ResultsError::InUse { folder: folder.to_owned(), holder: holder(file) });
                }
                Err(TryLockError::Error(error)) => {
                    drop(Self { path: path.clone(), file, made });
                    return Err(refused(error));
                }
            }
        }
        Err(ResultsError::InUse { folder: folder.to_owned(), holder: None })
    }

    /// Says in the file who holds it.
    fn name_holder(&mut self, work: &str) -> io::Result<()> {
        self.file.set_len(0)?;
        // In one piece: others read it at any moment.
        let line = format!("process {}{} ({work}{})\n", std::process::id(), on_host(), since(SystemTime::now()));
        self.file.write_all(line.as_bytes())
    }
}

/// Gives the folder back; one that was made for the lock goes, where nothing came into it.
impl Drop for FolderLock {
    fn drop(&mut self) {
        // Removed while it is still locked, so that whoever opens it from now on makes a new one. Windows does not let go of a
        // file that is open: there it stays.
        if cfg!(unix) {
            let _ = fs::remove_file(&self.path);
        }
        // Explicitly, since a child process may hold a copy of the file.
        let _ = self.file.unlock();
        remove_empty(&self.made);
    }
}

/// Whether something else than a folder is at the path: a file, or a link that leads nowhere.
fn is_no_folder(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|metadata| !metadata.is_dir())
}

/// Whether the path still leads to the file, which its last holder may have removed.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |metadata: fs::Metadata| (metadata.dev(), metadata.ino());
    file.metadata().map(identity).ok() == fs::metadata(path).map(identity).ok()
}

/// Nothing removes the file here.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

/// Who holds the lock, where the file says so already and can be read.
fn holder(mut file: File) -> Option<String> {
    const LONGEST_CHARS: usize = 200;
    let mut text = String::new();
    file.read_to_string(&mut text).ok()?;
    let (line, _) = text.split_once('\n')?;
    let line: String = line.chars().filter(|character| !character.is_control()).collect();
    Some(line.chars().take(LONGEST_CHARS).collect()).filter(|line: &String| !line.is_empty())
}

/// `, since DATE`, where the clock of the machine shows a date that has a form.
fn since(now: SystemTime) -> String {
    date(now).map_or_else(String::new, |date| format!(", since {date}"))
}

/// ` on NAME`, where the machine says its name: a folder may be shared by several.
fn on_host() -> String {
    let named = fs::read_to_string("/proc/sys/kernel/hostname").ok();
    let named = named.or_else(|| std::env::var("COMPUTERNAME").ok());
    named.map_or_else(String::new, |name| format!(" on {}", name.trim()))
}

/// Removes folders that were made, the innermost first. One with something else in it meanwhile is not empty and stays, as it should.
fn remove_empty(made: &[PathBuf]) {
    for folder in made {
        if fs::remove_dir(folder).is_err() {
            break;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::{AtomicUsize, Ordering};

    #[test]
    fn the_second_writer_is_told_of_the_first() {
        let root = tempfile::tempdir().expect("a folder");
        let folder = root.path().join("a/b");
        let first = FolderLock::take(&folder, "simulation 'one'").expect("a new folder");
        let error = FolderLock::take(&folder, "simulation 'two'").expect_err("it is held");
        let words = error.to_string();
        let holder = format!("process {}", std::process::id());
        assert!(words.contains(&holder) && words.contains("(simulation 'one', since 2"), "{words}");
        drop(first);
        assert!(!root.path().join("a").exists(), "nothing is left of it");
        // Left behind by a process that was killed: it is not locked any more.
        fs::create_dir_all(&folder).expect("writable");
        fs::write(folder.join(LOCK_FILE), "process 1 (a simulation, since yesterday)\nand more").expect("writable");
        drop(FolderLock::take(&folder, "simulation 'two'").expect("nobody holds it"));
        assert!(folder.exists(), "it was there before");
    }

    #[test]
    fn a_clock_before_1970_is_left_out() {
        let epoch = SystemTime::UNIX_EPOCH;
        assert_eq!(since(epoch - std::time::Duration::from_secs(1)), "");
        assert_eq!(since(epoch), ", since 1970-01-01T00:00:00Z");
    }

    #[test]
    fn what_is_no_folder_is_refused_at_once() {
        let root = tempfile::tempdir().expect("a folder");
        let file = root.path().join("out");
        fs::write(&file, "results of somebody").expect("writable");
        let error = FolderLock::take(&file, "test").expect_err("a file is in its place");
        assert!(matches!(&error, ResultsError::Write { .. }), "{error}");
        assert_eq!(fs::read_to_string(&file).expect("it is still there"), "results of somebody");
    }

    #[test]
    fn never_two_at_once() {
        const WRITERS: usize = 8;
        const ROUNDS: usize = 200;
        let root = tempfile::tempdir().expect("a folder");
        let folder = root.path().join("out");
        let (inside, held) = (AtomicUsize::new(0), AtomicUsize::new(0));
        std::thread::scope(|scope| {
            for _ in 0..WRITERS {
                scope.spawn(|| {
                    for _ in 0..ROUNDS {
                        match FolderLock::take(&folder, "test") {
                            Ok(lock) => {
                                assert_eq!(inside.fetch_add(1, Ordering::SeqCst), 0, "two hold the folder");
                                held.fetch_add(1, Ordering::SeqCst);
                                assert!(folder.join(LOCK_FILE).exists(), "the file of whoever holds it is gone");
                                inside.fetch_sub(1, Ordering::SeqCst);
                                drop(lock);
                            }
                            Err(ResultsError::InUse { .. }) => {}
                            Err(error) => panic!("{error}"),
                        }
                    }
                });
            }
        });
        // How often depends on how the threads are scheduled.
        assert!(held.into_inner() > 0, "nobody ever held it");
        // It may stay, where another one had made it than held it last.
        let left = fs::read_dir(&folder).map_or(0, Iterator::count);
        assert_eq!(left, 0, "no file is left");
    }
}
