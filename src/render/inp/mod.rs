//! A scene as a deck of keywords for CalculiX or Abaqus (`.inp`).
//!
//! The bodies must stand in touch: the deck has no other means to find the contact than soft
//! springs and, where a rigid plane is driven by force, a first step that moves it a little way.
//! Everything is in the units of the case; the deck says which.

mod contact;
mod deck;
mod format;
mod head;
mod hold;
mod mesh;
mod names;
mod settings;
mod steps;
mod tie;
mod turning;

pub use deck::{
    Deck, DeckFollower, DeckPair, DeckTie, Driven, Heat, NodalForce, NodalTemperature, Springs,
    Turning,
};
pub use names::Names;
pub use settings::{ContactType, Settings};

use std::io::{self, Write};

impl Deck<'_> {
    /// Writes the deck.
    ///
    /// # Errors
    /// Where `out` cannot be written.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        self.head(out)?;
        self.mesh(out)?;
        self.steel(out)?;
        self.ties(out)?;
        self.contact(out)?;
        self.hold(out)?;
        self.steps(out)
    }
}
