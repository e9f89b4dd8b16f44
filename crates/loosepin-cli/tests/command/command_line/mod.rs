//! Runs the command in a folder of its own.
#![allow(dead_code, reason = "each test file uses a part of it")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// A folder that vanishes, with model and study files in it.
pub struct Desk {
    folder: tempfile::TempDir,
}

/// Output and exit status of a command.
pub struct Said {
    /// Standard output.
    pub output: String,
    /// Standard error.
    pub messages: String,
    /// Exit status.
    pub status: i32,
}

/// A file of a case.
pub fn case_file(case: &str, file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases").join(case).join(file)
}

/// The text of a file of a case.
pub fn case_text(case: &str, file: &str) -> String {
    fs::read_to_string(case_file(case, file)).expect("the case is there")
}

impl Desk {
    /// An empty folder.
    pub fn new() -> Desk {
        Desk { folder: tempfile::tempdir().expect("a folder for the test") }
    }

    /// A folder with the `model.toml` of a case.
    pub fn with_model(case: &str) -> Desk {
        let desk = Desk::new();
        desk.write("model.toml", &case_text(case, "model.toml"));
        desk
    }

    /// A path in the folder.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Writes a file.
    pub fn write(&self, name: &str, text: &str) {
        fs::write(self.path(name), text).expect("the folder can be written");
    }

    /// Reads a file.
    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// The command, to be run in the folder.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_loosepin"));
        command.args(arguments).current_dir(self.folder.path()).stdin(Stdio::null()).env("COLUMNS", "100");
        // Pages have the date when they are written.
        command.env("SOURCE_DATE_EPOCH", "0");
        command
    }

    /// Runs the command in the folder.
    pub fn run(&self, arguments: &[&str]) -> Said {
        self.command(arguments).output().expect("the command starts").into()
    }

    /// Pastes a command into a shell in the folder.
    #[cfg(unix)]
    pub fn paste(&self, command: &str) -> Said {
        let program = Path::new(env!("CARGO_BIN_EXE_loosepin")).parent().expect("a folder");
        let mut path = std::ffi::OsString::from(program);
        path.push(":");
        path.push(std::env::var_os("PATH").unwrap_or_default());
        let mut shell = Command::new("sh");
        shell.args(["-c", command]).current_dir(self.folder.path()).env("PATH", path).stdin(Stdio::null());
        shell.env("SOURCE_DATE_EPOCH", "0");
        shell.output().expect("a shell").into()
    }

    /// Runs the command, which must succeed.
    pub fn succeed(&self, arguments: &[&str]) -> Said {
        let said = self.run(arguments);
        assert_eq!(said.status, 0, "loosepin {}\n{}", arguments.join(" "), said.messages);
        said
    }

    /// Runs the command, which must fail with exit status 2, print no data, and say exactly this.
    pub fn fail(&self, arguments: &[&str], messages: &str) {
        let said = self.run(arguments);
        assert_eq!(said.messages.trim_end(), messages, "loosepin {}", arguments.join(" "));
        assert_eq!((said.status, said.output.as_str()), (2, ""), "loosepin {}", arguments.join(" "));
    }
}

impl From<Output> for Said {
    fn from(output: Output) -> Said {
        let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
        let status = output.status.code().expect("no signal ended the command");
        Said { output: text(output.stdout), messages: text(output.stderr), status }
    }
}

/// A table of numbers with a header line.
pub struct Columns {
    names: Vec<String>,
    rows: Vec<Vec<f64>>,
}

impl Columns {
    /// Reads CSV; cells that are no numbers are not-a-number.
    pub fn from_csv(text: &str) -> Columns {
        let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let names = lines.next().expect("a header").into_iter().map(str::to_owned).collect();
        let rows = lines.map(|cells| cells.iter().map(|cell| cell.parse().unwrap_or(f64::NAN)).collect()).collect();
        Columns { names, rows }
    }

    /// Names in their order.
    pub fn names(&self) -> Vec<&str> {
        self.names.iter().map(String::as_str).collect()
    }

    /// A column by its name.
    pub fn column(&self, name: &str) -> Vec<f64> {
        let index = self.names.iter().position(|known| known == name).unwrap_or_else(|| panic!("no column {name}"));
        self.rows.iter().map(|row| row[index]).collect()
    }
}
