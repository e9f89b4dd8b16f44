//! AFL++ fuzzes the reader of study files by this.

fn main() {
    afl::fuzz!(|bytes: &[u8]| {
        loosepin_fuzz::study::read(bytes);
    });
}
