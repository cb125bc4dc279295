//! Writes the four lab reports as pages: one file each, which any browser opens.
//!
//! ```sh
//! cargo run --release --example lab_reports
//! ```

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{env, fs};

use indicatif::{ProgressBar, ProgressStyle};
use report::pages;

const HELP: &str = "\
Writes the four lab reports as self-contained HTML pages, with derivations, examples, mistakes and figures.

usage: cargo run --release --example lab_reports [-- OPTIONS]

  -o, --output FOLDER   where the pages go; made if it is not there (default: target/lab_reports)
      --svg             write each drawing as an SVG file of its own as well
  -h, --help            this text";

/// What was asked for.
struct Options {
    output: PathBuf,
    svg: bool,
}

/// Reads the arguments; nothing if help was asked for.
fn options(arguments: impl Iterator<Item = String>) -> Result<Option<Options>, String> {
    let mut options = Options { output: PathBuf::from("target/lab_reports"), svg: false };
    let mut arguments = arguments;
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "-h" | "--help" => return Ok(None),
            "-o" | "--output" => {
                let folder = arguments.next().ok_or_else(|| format!("{argument} needs a folder"))?;
                options.output = PathBuf::from(folder);
            }
            "--svg" => options.svg = true,
            other => return Err(format!("there is no option `{other}`; `--help` lists them all")),
        }
    }
    Ok(Some(options))
}

fn write(path: &Path, text: &str) -> Result<u64, String> {
    fs::write(path, text).map_err(|error| format!("{}: {error}", path.display()))?;
    Ok(text.len() as u64)
}

/// Writes everything; the files and their sizes.
fn run(options: &Options) -> Result<Vec<(PathBuf, u64)>, String> {
    fs::create_dir_all(&options.output).map_err(|error| format!("{}: {error}", options.output.display()))?;
    let bar = ProgressBar::new(pages::ALL.len() as u64);
    if let Ok(style) = ProgressStyle::with_template("  {bar:32} {pos}/{len}  {msg}") {
        bar.set_style(style);
    }
    let mut files = Vec::new();
    for report in pages::ALL {
        bar.set_message(report.title);
        bar.tick();
        let page = (report.write)().map_err(|error| format!("{}: {error}", report.file))?;
        let path = options.output.join(format!("{}.html", report.file));
        let size = write(&path, &page.finish())?;
        files.push((path, size));
        if options.svg {
            for (name, drawing) in page.drawings() {
                let path = options.output.join(format!("{}-{name}.svg", report.file));
                let size = write(&path, &drawing.standalone())?;
                files.push((path, size));
            }
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok(files)
}

fn main() -> ExitCode {
    let outcome = match options(env::args().skip(1)) {
        Ok(Some(options)) => run(&options),
        Ok(None) => {
            println!("{HELP}");
            return ExitCode::SUCCESS;
        }
        Err(message) => Err(message),
    };
    match outcome {
        Ok(files) => {
            for (path, size) in files {
                println!("{:>6} kB  {}", size.div_ceil(1000), path.display());
            }
            ExitCode::SUCCESS
        }
        Err(message) => {
            eprintln!("lab_reports: {message}");
            ExitCode::FAILURE
        }
    }
}
