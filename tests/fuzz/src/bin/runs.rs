//! AFL++ fuzzes the reader of files of runs by this.

fn main() {
    afl::fuzz!(|bytes: &[u8]| loosepin_fuzz::runs::read(bytes));
}
