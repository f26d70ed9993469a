//! Whatever a checkpoint holds: an increment that one can go on from, or an error.
#![no_main]

use brinell::case;
use brinell::product::job::Checkpoint;
use brinell::model::mesh::msh;
use brinell::model::scene::Scene;
use libfuzzer_sys::fuzz_target;
use std::path::Path;
use std::sync::OnceLock;

fn scene() -> &'static (Scene, Checkpoint) {
    static SCENE: OnceLock<(Scene, Checkpoint)> = OnceLock::new();
    SCENE.get_or_init(|| {
        let case = case::parse(
            "stack.toml",
            include_str!("../../cases/extreme/stack.toml"),
        );
        let mesh = msh::parse(include_bytes!("../../cases/extreme/single.msh"), "single.msh");
        let scene = case.unwrap().scene(mesh.unwrap()).unwrap();
        let checkpoint = Checkpoint::new(Path::new(""), &scene);
        (scene, checkpoint)
    })
}

fuzz_target!(|bytes: &[u8]| {
    let (scene, checkpoint) = scene();
    if let Err(error) = checkpoint.restart(bytes) {
        drop(error.to_string());
    }
    // The same with a head that fits, without which next to nothing would be decoded.
    match checkpoint.restart(&checkpoint.sealed(bytes)) {
        Ok(restart) => drop(restart.check(scene)),
        Err(error) => drop(error.to_string()),
    }
});
