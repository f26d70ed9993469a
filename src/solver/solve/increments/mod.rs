//! Steps and increments: automatic size, cut-back, and what is kept at each accepted one.
//!
//! Start with [`solve`], then [`steps`].

pub mod accept;
pub mod accompany;
pub mod companion;
pub mod cut_back;
pub mod diagnosis;
pub mod elastic_end;
pub mod enlarge;
pub mod first_guess;
pub mod flow_plan;
pub mod flowing;
pub mod measure;
pub mod no_balance;
pub mod place;
pub mod rebuild;
pub mod restore;
pub mod run;
pub mod save;
pub mod size;
pub mod solution;
pub mod solve;
pub mod steps;
pub mod turning_flow;
pub mod unloading;
