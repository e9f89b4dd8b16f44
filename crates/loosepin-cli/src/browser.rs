//! Opening an address in the browser of the person.
//!
//! The address holds a secret, which must not stand on a command line: every user of the machine can read those. The browser is given
//! a file that nobody else can read, and that leads to the address.

use std::env;
use std::io;
use std::process::{Command, Stdio};

use loosepin::files::{PrivateFile, create_private};

/// Lets the system open `address`; gives the file that leads to it, which goes when it is dropped.
///
/// # Errors
/// The file cannot be written; there is no desktop, or nothing that opens files on it.
pub fn open(address: &str) -> io::Result<PrivateFile> {
    let opener = opener().ok_or_else(|| io::Error::other("there is no desktop"))?;
    let page = format!(
        "<!doctype html><meta charset=\"utf-8\"><title>loosepin</title>\
         <meta http-equiv=\"refresh\" content=\"0; url={address}\"><a href=\"{address}\">Open the studio</a>\n"
    );
    let page = create_private(&env::temp_dir(), "loosepin-studio", "html", page.as_bytes())?;
    let [program, before @ ..] = opener else { return Err(io::Error::other("there is no desktop")) };
    let quiet = Stdio::null;
    Command::new(program).args(before).arg(page.path()).stdin(quiet()).stdout(quiet()).stderr(quiet()).spawn()?;
    Ok(page)
}

/// What opens files on this desktop; `None` if there is none.
fn opener() -> Option<&'static [&'static str]> {
    if cfg!(target_os = "macos") {
        Some(&["open"])
    } else if cfg!(windows) {
        Some(&["explorer"])
    } else {
        let has_desktop = ["DISPLAY", "WAYLAND_DISPLAY"].iter().any(|name| env::var_os(name).is_some());
        has_desktop.then_some(&["xdg-open"])
    }
}
