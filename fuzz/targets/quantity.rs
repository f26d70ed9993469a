//! Whatever the text of a quantity is: a finite number with a dimension, or an error.
#![no_main]

use brinell::ground::units::{Quantity, UnitSystem};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    if let Ok(quantity) = Quantity::parse(text) {
        let dimension = quantity.dimension();
        for system in UnitSystem::ALL {
            if let Ok(value) = quantity.value_in(system, dimension) {
                assert!(value.is_finite(), "{text:?} is {value}");
            }
        }
    }
});
