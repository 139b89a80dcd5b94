#lang racket/base
;; Fields on one line and as TeX.

(require mechanics mechanics/geometry
         "../support/checks.rkt")

(define-coordinates (up x theta) R2-rect)
(define v (literal-vector-field 'v R2-rect))
(define w (literal-1form-field 'omega R2-rect))
(define nabla (covariant-derivative (literal-Cartan 'G R2-rect)))

(define-syntax-rule (looks [field line TeX] ...)
  (begin
    (test-case (format "~s" 'field)
      (check-equal? (->infix field) line)
      (check-equal? (->TeX field) TeX))
    ...))

(looks
 [d/dx "∂/∂x" "\\frac{\\partial{}}{\\partial{}x}"]
 [dtheta "dθ" "\\text{d}\\theta"]
 [(- (* x d/dtheta) (* theta d/dx)) "x (∂/∂θ) − θ (∂/∂x)"
  "x\\,\\frac{\\partial{}}{\\partial{}\\theta} - \\theta\\,\\frac{\\partial{}}{\\partial{}x}"]
 [(wedge dx dtheta) "dx ∧ dθ" "\\text{d}x\\wedge \\text{d}\\theta"]
 [(* x (wedge dx dtheta)) "x (dx ∧ dθ)" "x\\,(\\text{d}x\\wedge \\text{d}\\theta)"]
 [(d w) "dω" "\\text{d}\\omega"]
 [(d (* x w)) "d(x ω)" "\\text{d}(x\\,\\omega)"]
 [(commutator v d/dx) "[v, ∂/∂x]"
  "\\text{[}v\\text{, }\\frac{\\partial{}}{\\partial{}x}\\text{]}"]
 [((Lie-derivative v) w) "£ᵥ ω" "\\text{\\pounds{}}_{v}\\text{ }\\omega"]
 [((nabla d/dx) v) "∇ₓ v" "\\text{\\ensuremath{\\nabla}}_{x}\\text{ }v"]
 [((nabla (+ v d/dx)) v) "∇(v + ∂/∂x) v"
  "\\text{\\ensuremath{\\nabla}}\\left(v + \\frac{\\partial{}}{\\partial{}x}\\right)\\text{ }v"]
 [((interior-product v) (wedge dx w)) "interior-product(v)(dx ∧ ω)"
  "\\text{interior-product}(v)(\\text{d}x\\wedge \\omega)"]
 [(dx v) "(dx)(v)" "(\\text{d}x)(v)"])

(test-case "a coordinate's name has two letters at most; names that merely begin with d are names"
  (define-coordinates (up ab abc) R2-rect)
  (check-equal? (->infix d/dab) "∂/∂ab")
  (check-equal? (->infix dabc) "dabc")
  (check-equal? (->infix (literal-1form-field 'delta R2-rect)) "δ")
  (check-equal? (->infix (literal-1form-field 'density R2-rect)) "density"))
