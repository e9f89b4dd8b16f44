//! AFL++ fuzzes the reader of stores of runs by this, in a folder of its own among the temporary ones.

fn main() {
    let folder = std::env::temp_dir().join(format!("loosepin-fuzz-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder for the store");
    afl::fuzz!(|bytes: &[u8]| loosepin_fuzz::store::read(bytes, &folder));
    std::fs::remove_dir_all(&folder).expect("the folder of the store goes");
}
