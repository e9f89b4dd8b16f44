//! The secret by which the page shows that it was opened by the person who started the server.

/// Bytes of a token: nobody guesses 256 bits.
const BYTES: usize = 32;

/// 64 hexadecimal digits.
#[derive(Clone)]
pub struct Token(String);

impl Token {
    /// A fresh one from the system's source of random bytes.
    ///
    /// # Errors
    /// The system has no such source.
    pub fn new() -> Result<Self, getrandom::Error> {
        let mut bytes = [0; BYTES];
        getrandom::fill(&mut bytes)?;
        Ok(Self(bytes.iter().map(|byte| format!("{byte:02x}")).collect()))
    }

    /// One that [`Self::text`] gave before.
    pub fn from_text(text: &str) -> Self {
        Self(text.to_owned())
    }

    /// As it stands in the address.
    pub fn text(&self) -> &str {
        &self.0
    }

    /// Whether `text` is it. The time that this takes says nothing on how much of it is right.
    pub fn is(&self, text: &str) -> bool {
        let differing = self.0.bytes().zip(text.bytes()).fold(0, |differing, (own, other)| differing | (own ^ other));
        text.len() == self.0.len() && std::hint::black_box(differing) == 0
    }
}

#[cfg(test)]
mod tests {
    use super::Token;

    #[test]
    fn analytic_a_token_is_itself_alone() {
        let [token, other] = [(); 2].map(|()| Token::new().unwrap());
        assert_eq!(token.text().len(), 64);
        assert!(token.is(token.text()) && !token.is(other.text()) && !token.is(""));
        assert!(!token.is(&token.text()[1..]) && !token.is(&format!("{}0", token.text())));
    }
}
