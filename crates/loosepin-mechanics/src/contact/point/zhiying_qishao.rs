//! Zhiying and Qishao 2006.

use super::law::PointLaw;

/// Zhiying and Qishao 2006: χ = 3(1 - c_e²) exp(2(1 - c_e))/4.
#[derive(Debug)]
pub struct ZhiyingQishao;

impl PointLaw for ZhiyingQishao {
    fn name(&self) -> &'static str {
        "zhiying-qishao"
    }
    fn source(&self) -> &'static str {
        "Zhiying and Qishao 2006: χ = 3(1 - c_e²) exp(2(1 - c_e))/4"
    }
    fn damping_factor(&self, restitution: f64) -> f64 {
        0.75 * (1.0 - restitution * restitution) * libm::exp(2.0 * (1.0 - restitution))
    }
}

#[cfg(test)]
mod tests {
    use super::ZhiyingQishao;
    use crate::contact::point::delivered::assert_delivers;

    #[test]
    fn analytic_delivered_restitution() {
        assert_delivers(&ZhiyingQishao, [0.4826, 0.6796, 0.8959]);
    }
}
