//! What is known of the program when it is built: a word for its code and data, one for its catalogue, and the files of the page packed as
//! small as they get.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

/// What the answers follow from.
const SOURCES: [&str; 9] = [
    "Cargo.lock",
    "src",
    "catalogue",
    "validation",
    "crates/identification/src",
    "crates/optimum/src",
    "crates/reading/src",
    "crates/terramechanics/src",
    "crates/uncertainty/src",
];

/// Window of the packed files, as a power of two (bytes): none is longer.
const WINDOW: u32 = 18;

/// Shortest file that is packed (bytes).
const SHORT: usize = 1 << 10;

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=static");
    SOURCES.iter().for_each(|path| println!("cargo::rerun-if-changed={path}"));
    // Not named like settings: cargo hands them on to what it runs.
    println!("cargo::rustc-env=VERSION_OF_BUILD={:016x}", version_of(&SOURCES)?);
    println!("cargo::rustc-env=VERSION_OF_CATALOGUE={:016x}", version_of(&["catalogue"])?);
    pack(Path::new("static"), &PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default()).join("packed"))
}

/// A word for what these files hold, and how they are called.
fn version_of(paths: &[&str]) -> io::Result<u64> {
    let mut hash = DefaultHasher::new();
    for path in paths.iter().map(Path::new) {
        for file in files(path)? {
            file.hash(&mut hash);
            fs::read(&file)?.hash(&mut hash);
        }
    }
    Ok(hash.finish())
}

/// The files at and under a path, in the order of their names.
fn files(path: &Path) -> io::Result<Vec<PathBuf>> {
    if path.is_file() {
        return Ok(vec![path.to_owned()]);
    }
    let mut entries = fs::read_dir(path)?.map(|entry| Ok(entry?.path())).collect::<io::Result<Vec<_>>>()?;
    entries.sort();
    Ok(entries.iter().map(|path| files(path)).collect::<io::Result<Vec<_>>>()?.concat())
}

/// Packs the files of a folder that get shorter by it into another, under their own names.
fn pack(folder: &Path, into: &Path) -> io::Result<()> {
    if into.exists() {
        fs::remove_dir_all(into)?;
    }
    fs::create_dir_all(into)?;
    for file in files(folder)? {
        let plain = fs::read(&file)?;
        let packed = brotli(&plain)?;
        let Ok(name) = file.strip_prefix(folder) else { continue };
        if plain.len() >= SHORT && packed.len() < plain.len() {
            let path = into.join(name);
            fs::create_dir_all(path.parent().unwrap_or(into))?;
            fs::write(path, packed)?;
        }
    }
    Ok(())
}

fn brotli(plain: &[u8]) -> io::Result<Vec<u8>> {
    let mut packer = brotli::CompressorWriter::new(Vec::new(), 4096, 11, WINDOW);
    packer.write_all(plain)?;
    packer.flush()?;
    Ok(packer.into_inner())
}
