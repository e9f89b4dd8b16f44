//! Numbers of runs that need not be in memory all at once: in a file without a name, read as if they were memory.
//!
//! Numbers are written once and never change. What was read of them lately stays in memory, [`MAX_READ_BYTES`] at most (on Unix; elsewhere
//! the system decides); the operating system reads the rest again when it is asked for. Where the file has no room for more, what would
//! follow stays in memory. The file has to lie on a disk of the machine: where what was written cannot be read again, as on a network drive
//! that has gone, the system ends the process.
#![allow(unsafe_code, reason = "a file can be read as memory only by one who knows that nobody else changes it")]

use std::fmt;
use std::fs::File;
use std::io::{self, Seek, SeekFrom, Write};
use std::ops::{Deref, Range};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, Weak};

use memmap2::{Mmap, MmapOptions};

/// Bytes of numbers that were read lately and are left in memory, at most.
const MAX_READ_BYTES: usize = 128 << 20;
/// Parts of the file begin at multiples of this, as pages do on all systems.
const ALIGNMENT: u64 = 1 << 16;

/// A file without a name that takes numbers.
#[derive(Clone)]
pub struct Scratch {
    file: Arc<Mutex<File>>,
    read: Arc<Mutex<Read>>,
}

/// Parts of which pages are in memory, and their sizes together.
#[derive(Default)]
struct Read {
    /// Weak references: the parts own this list.
    parts: Vec<Weak<MappedChunk>>,
    bytes: usize,
}

/// Numbers that were written together.
struct MappedChunk {
    map: Mmap,
    /// Whether it stands among those that were read.
    is_read: AtomicBool,
    read: Arc<Mutex<Read>>,
}

/// Numbers, wherever they are.
#[derive(Clone)]
pub(crate) enum Numbers {
    /// In memory.
    InMemory(Arc<[f64]>),
    /// In a file: this range of a part.
    InFile(FileRange),
}

/// A range of a part.
#[derive(Clone)]
pub(crate) struct FileRange {
    part: Arc<MappedChunk>,
    range: Range<usize>,
}

impl Scratch {
    /// A new file in `folder`. It has no name there: whatever ends the process, it is gone.
    ///
    /// # Errors
    ///
    /// The file cannot be made.
    pub fn in_folder(folder: &Path) -> io::Result<Self> {
        Ok(Self { file: Arc::new(Mutex::new(loosepin_files::anonymous_file(folder)?)), read: Arc::default() })
    }

    /// Writes `numbers`, of which there are some.
    ///
    /// # Errors
    ///
    /// The disk is full, or the system refuses another part.
    pub(crate) fn put(&self, numbers: &[f64]) -> io::Result<FileRange> {
        let mut file = lock(&self.file);
        let begin = file.seek(SeekFrom::End(0))?.next_multiple_of(ALIGNMENT);
        let map = map_written(&mut file, begin, numbers).inspect_err(|_| {
            // What was written in part would fill the disk for the results. It is mapped nowhere.
            let _ = file.set_len(begin);
        })?;
        let part = MappedChunk { map, is_read: AtomicBool::new(false), read: Arc::clone(&self.read) };
        Ok(FileRange { part: Arc::new(part), range: 0..numbers.len() })
    }
}

/// Writes `numbers` at `begin`, which is not before the end of `file`, and maps them.
fn map_written(file: &mut File, begin: u64, numbers: &[f64]) -> io::Result<Mmap> {
    file.seek(SeekFrom::Start(begin))?;
    // SAFETY: every byte of a number is a byte, and numbers need a wider alignment than bytes.
    let bytes = unsafe { std::slice::from_raw_parts(numbers.as_ptr().cast::<u8>(), size_of_val(numbers)) };
    file.write_all(bytes)?;
    // SAFETY: the file has no name, so that nobody else opens it; only this function writes to it, never before the end of what was
    // there, and only what could not be mapped is cut off. So the mapped bytes never change.
    unsafe { MmapOptions::new().offset(begin).len(bytes.len()).map(&*file) }
}

impl MappedChunk {
    /// All of its numbers. Where too much has been read, what was read before goes out of memory first.
    fn numbers(self: &Arc<Self>) -> &[f64] {
        if !self.is_read.load(Ordering::Relaxed) {
            self.note();
        }
        let bytes: &[u8] = &self.map;
        debug_assert!(bytes.as_ptr().cast::<f64>().is_aligned(), "parts begin at pages");
        // SAFETY: the bytes were numbers when they were written, a whole count of them, and begin at a page; any bits are a number.
        unsafe { std::slice::from_raw_parts(bytes.as_ptr().cast::<f64>(), bytes.len() / size_of::<f64>()) }
    }

    /// Puts it among those that were read.
    fn note(self: &Arc<Self>) {
        let mut read = lock(&self.read);
        if self.is_read.swap(true, Ordering::Relaxed) {
            return;
        }
        read.bytes += self.map.len();
        read.parts.push(Arc::downgrade(self));
        if read.bytes > MAX_READ_BYTES {
            for part in std::mem::take(&mut *read).parts.iter().filter_map(Weak::upgrade) {
                // Whoever reads it from now on notes it again.
                part.is_read.store(false, Ordering::Relaxed);
                part.leave();
            }
        }
    }

    /// Its pages go out of memory; who is reading them reads them again from the file.
    #[cfg(unix)]
    fn leave(&self) {
        // SAFETY: of a file that is mapped for reading, pages that are left come back with the bytes of the file.
        let left = unsafe { self.map.unchecked_advise(memmap2::UncheckedAdvice::DontNeed) };
        // Where the system does not take the advice the pages stay, and the numbers are the same.
        let _ = left;
    }

    #[cfg(not(unix))]
    fn leave(&self) {}
}

impl FileRange {
    /// The part of it at `range`.
    pub fn at(&self, range: Range<usize>) -> Self {
        let begin = self.range.start;
        debug_assert!(begin + range.end <= self.range.end, "a range of its own numbers");
        Self { part: Arc::clone(&self.part), range: begin + range.start..begin + range.end }
    }
}

impl Deref for FileRange {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        &self.part.numbers()[self.range.clone()]
    }
}

impl Deref for Numbers {
    type Target = [f64];

    fn deref(&self) -> &[f64] {
        match self {
            Self::InMemory(numbers) => numbers,
            Self::InFile(away) => away,
        }
    }
}

impl fmt::Debug for Numbers {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_list().entries(self.iter()).finish()
    }
}

impl fmt::Debug for FileRange {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{} numbers", self.range.len())
    }
}

impl fmt::Debug for Scratch {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("Scratch")
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::{MAX_READ_BYTES, Numbers, Scratch, lock};
    use rayon::prelude::*;
    use std::sync::Arc;

    fn scratch() -> Scratch {
        Scratch::in_folder(&std::env::temp_dir()).expect("a file")
    }

    /// A number for each place of each part.
    fn number(part: usize, place: usize) -> f64 {
        (part * 1_000_003 + place) as f64 + 0.25
    }

    #[test]
    fn identity_numbers_are_what_was_written_however_often_they_left() {
        let scratch = scratch();
        let each = 1 << 17;
        let count = 4 * MAX_READ_BYTES / (8 * each);
        let parts: Vec<_> = (0..count)
            .map(|part| scratch.put(&(0..each).map(|place| number(part, place)).collect::<Vec<_>>()).expect("room"))
            .collect();
        // Several readers at once, each in an order of its own.
        (0..8_usize).into_par_iter().for_each(|reader| {
            for step in 0..3 * count {
                let part = (step * (2 * reader + 1)) % count;
                let place = (step * 7919) % (each - 8);
                let expected: Vec<f64> = (place..place + 8).map(|place| number(part, place)).collect();
                assert_eq!(parts[part].at(place..place + 8)[..], expected[..]);
            }
        });
        let read = lock(&scratch.read);
        assert!(read.bytes <= MAX_READ_BYTES, "{} bytes", read.bytes);
        assert!(!read.parts.is_empty());
    }

    #[test]
    fn no_name_is_left_and_no_other_bits() {
        let folder = std::env::temp_dir().join(format!("loosepin-scratch-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        let scratch = Scratch::in_folder(&folder).expect("a file");
        assert_eq!(std::fs::read_dir(&folder).expect("a folder").count(), 0);
        let odd = [f64::NAN, -0.0, f64::INFINITY, 5e-324, f64::from_bits(0x7ff8_0000_dead_beef)];
        let numbers = Numbers::InFile(scratch.put(&odd).expect("room"));
        let bits = |numbers: &[f64]| numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&numbers), bits(&odd));
        std::fs::remove_dir_all(&folder).expect("a folder");
    }

    #[test]
    fn nothing_is_left_when_it_is_dropped() {
        let scratch = scratch();
        let numbers = scratch.put(&[1.5; 1000]).expect("room");
        assert_eq!(numbers[999], 1.5);
        let (part, read) = (Arc::downgrade(&numbers.part), Arc::downgrade(&scratch.read));
        drop(scratch);
        assert_eq!(numbers[0], 1.5, "numbers outlive the file that they are in");
        drop(numbers);
        assert!(part.upgrade().is_none() && read.upgrade().is_none());
    }

    #[test]
    fn a_folder_that_is_not_there_is_an_error() {
        assert!(Scratch::in_folder(std::path::Path::new("/nowhere/at/all")).is_err());
    }
}
