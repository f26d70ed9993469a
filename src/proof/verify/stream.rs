//! Random numbers that are the same on every machine.

use libm::{exp, log};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// A stream of numbers that is the same on every machine and with every version.
pub struct Stream(ChaCha8Rng);

impl Stream {
    pub fn new(seed: u64, number: usize) -> Self {
        let mut stream = ChaCha8Rng::seed_from_u64(seed);
        stream.set_stream(number as u64);
        Self(stream)
    }

    /// Evenly from 0 to 1, 1 left out.
    pub fn share(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 * 2f64.powi(-53)
    }

    pub fn between(&mut self, [low, high]: [f64; 2]) -> f64 {
        low + (high - low) * self.share()
    }

    /// Evenly in the logarithm.
    pub fn scale(&mut self, [low, high]: [f64; 2]) -> f64 {
        exp(self.between([log(low), log(high)]))
    }

    pub fn of<T: Copy, const N: usize>(&mut self, choices: [T; N]) -> T {
        choices[(self.share() * N as f64) as usize % N]
    }
}
