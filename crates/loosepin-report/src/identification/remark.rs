//! Remarks below a table.

use crate::wording::capitalised;
use loosepin_text::article::Text;

/// A remark, of which a page makes a sentence.
pub(super) fn remark(words: String) -> Text {
    Text::by_medium(format!("{}.", capitalised(&words)), words)
}
