pub(crate) mod altered;
mod files;
mod shapes;
mod speed;
