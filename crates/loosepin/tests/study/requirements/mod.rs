//! Requirements of mechanisms whose share inside is known in closed form.

mod ball_four_bar;
mod drawn;
mod two_balls;
