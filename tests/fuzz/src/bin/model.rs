//! AFL++ fuzzes the reader of model files by this.

fn main() {
    afl::fuzz!(|bytes: &[u8]| {
        loosepin_fuzz::model::read(bytes);
    });
}
