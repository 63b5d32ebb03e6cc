//! A live session: one connection to it, shared by all pages.

mod hub;
mod operator;
mod upstream;

pub(crate) use hub::Hub;
pub(crate) use operator::Operator;
pub(crate) use upstream::Upstream;
