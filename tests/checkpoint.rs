//! A checkpoint with a bit turned over, or cut short, is refused or the same: never another answer, never a panic.

use brinell::case::{self, Case};
use brinell::product::job::{self, CHECKPOINT_FILE, Checkpoint, JobError, Options, find_mesh};
use brinell::solver::solve::Silent;
use std::path::Path;

/// Numbers below `end`, the same on every run (Steele, Lea and Flood's SplitMix64).
fn numbers(mut state: u64, end: usize) -> impl Iterator<Item = usize> {
    std::iter::repeat_with(move || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % end as u64) as usize
    })
}

fn case() -> Case {
    case::read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("cases/extreme/stack.toml")).unwrap()
}

#[test]
fn broken_bits_and_missing_ends_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let options = Options {
        out: Some(folder.path().to_owned()),
        ..Options::default()
    };
    job::run(&case(), &options, &mut Silent).unwrap();
    let mesh = find_mesh(&case(), None, &mut |_| {}).unwrap();
    let checkpoint = Checkpoint::new(folder.path(), &case().scene(mesh).unwrap());
    let sound = std::fs::read(folder.path().join(CHECKPOINT_FILE)).unwrap();
    let restart = format!("{:?}", checkpoint.restart(&sound).unwrap());

    // All of the head, and anywhere.
    let bits = (0..400).chain(numbers(17, 8 * sound.len())).take(1000);
    let flipped = bits.map(|bit| {
        let mut bytes = sound.clone();
        bytes[bit / 8] ^= 1 << (bit % 8);
        bytes
    });
    let cut = (0..40).chain(numbers(18, sound.len())).take(100);
    let cut = cut.map(|length| sound[..length].to_vec());
    let mut refused = 0;
    for bytes in flipped.chain(cut) {
        match checkpoint.restart(&bytes) {
            Ok(read) => assert_eq!(format!("{read:?}"), restart),
            Err(error @ JobError::Checkpoint { .. }) => {
                let said = error.to_string();
                let why = [
                    "is not a checkpoint",
                    "it is damaged",
                    "another case or mesh",
                ];
                assert!(why.iter().any(|why| said.contains(why)), "{said}");
                refused += 1;
            }
            Err(other) => panic!("{other}"),
        }
    }
    assert!(refused > 1000, "{refused}");
}
