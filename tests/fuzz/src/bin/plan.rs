//! AFL++ fuzzes what follows the reading of models and studies by this.

fn main() {
    afl::fuzz!(|bytes: &[u8]| {
        loosepin_fuzz::plan::read(bytes);
    });
}
