//! Closed-form solutions that tests, tables and sizing share.
