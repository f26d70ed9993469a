//! The checkpoint of a run: what it can go on from after it was stopped, whatever stopped it.
//!
//! A line that names the format, the hash of the scene, the hash of what follows, and then the
//! [`Restart`] as `postcard` writes it. A checkpoint is only used for the scene that it was made
//! for, apart from its numerical controls: whoever goes on may change them.

use super::error::JobError;
use crate::ground::file::FileError;
use crate::ground::file::write_atomically;
use crate::ground::hash::Fnv;
use crate::model::scene::{Controls, Scene};
use crate::solver::solve::Restart;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Its name in the folder of a run.
pub const FILE: &str = "checkpoint.bin";

const FORMAT: &[u8] = b"brinell checkpoint 4\n";

/// The checkpoint file of one scene.
#[derive(Debug, Clone)]
pub struct Checkpoint {
    path: PathBuf,
    scene: u64,
}

impl Checkpoint {
    /// That of `scene`, before it is solved, in `folder`.
    pub fn new(folder: &Path, scene: &Scene) -> Self {
        Self {
            path: folder.join(FILE),
            scene: fingerprint(scene),
        }
    }

    /// Replaces what was there.
    ///
    /// # Errors
    /// [`FileError::Write`]; what was there is then still there.
    pub fn write(&self, restart: &Restart) -> Result<(), FileError> {
        // Twice through all of it, and never all of it in memory: the hash stands before what it is of.
        let mut hash = Fnv::default();
        let hashed = postcard::to_io(restart, &mut hash);
        hashed.map_err(|error| FileError::Write {
            path: self.path.clone(),
            source: std::io::Error::other(error),
        })?;
        write_atomically(&self.path, |out| {
            out.write_all(&self.head(&hash))?;
            let written = postcard::to_io(restart, out);
            written.map(|_| ()).map_err(std::io::Error::other)
        })
    }

    /// The bytes of the file that holds `content`, a [`Restart`] as `postcard` writes it.
    pub fn sealed(&self, content: &[u8]) -> Vec<u8> {
        let mut hash = Fnv::default();
        // Writing to a hash cannot fail.
        let _ = hash.write_all(content);
        [self.head(&hash).as_slice(), content].concat()
    }

    /// What stands before content of this hash.
    fn head(&self, hash: &Fnv) -> Vec<u8> {
        let hash = hash.value().to_le_bytes();
        [FORMAT, &self.scene.to_le_bytes(), &hash].concat()
    }

    /// What an earlier run left; `None` where there is nothing.
    ///
    /// # Errors
    /// [`JobError::Checkpoint`] where the file is none, is damaged or belongs to another scene.
    pub fn read(&self) -> Result<Option<Restart>, JobError> {
        match crate::ground::input::bytes(&self.path) {
            Ok(bytes) => self.restart(&bytes).map(Some),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error) => Err(JobError::folder(&self.path, error)),
        }
    }

    /// What `bytes` hold, which are all of such a file.
    ///
    /// # Errors
    /// [`JobError::Checkpoint`] as [`Checkpoint::read`].
    pub fn restart(&self, bytes: &[u8]) -> Result<Restart, JobError> {
        let refused = |why: &str| JobError::Checkpoint {
            path: self.path.clone(),
            why: why.to_owned(),
        };
        let not_ours = "it is not a checkpoint that this version of Brinell can read";
        let rest = bytes.strip_prefix(FORMAT).ok_or(refused(not_ours))?;
        let damaged = || refused("it is damaged");
        let (scene, rest) = rest.split_first_chunk::<8>().ok_or_else(damaged)?;
        let (hash, content) = rest.split_first_chunk::<8>().ok_or_else(damaged)?;
        if u64::from_le_bytes(*scene) != self.scene {
            return Err(refused("it belongs to another case or mesh"));
        }
        if u64::from_le_bytes(*hash) != Fnv::of(content) {
            return Err(damaged());
        }
        postcard::from_bytes(content).map_err(|_| refused(not_ours))
    }
}

/// A hash of all of the scene but its name and the controls that no answer depends on.
fn fingerprint(scene: &Scene) -> u64 {
    let Controls {
        plasticity,
        element,
        ..
    } = scene.controls;
    let mut plain = scene.clone();
    plain.controls = Controls {
        plasticity,
        element,
        ..Controls::default()
    };
    plain.mesh.source.clear();
    plain.name.clear();
    let mut hash = Fnv::default();
    // Writing to a hash cannot fail.
    let _ = postcard::to_io(&plain, &mut hash);
    hash.value()
}
