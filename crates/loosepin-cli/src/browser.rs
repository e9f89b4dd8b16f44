//! Opens an address in the user's browser.
//!
//! The address contains a secret. It must not appear on a command line, because every user of the machine can read command lines. The
//! browser opens a private file that redirects to the address.

use std::env;
use std::io;
use std::process::{Command, Stdio};

use loosepin::files::{PrivateFile, create_private};

/// Opens `address` in the browser. Returns the file that redirects to it; dropping it deletes the file.
///
/// # Errors
/// The file cannot be written; there is no desktop, or it has no program that opens files.
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

/// The program that opens files on this desktop; `None` if there is none.
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
