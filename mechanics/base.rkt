#lang racket/base
;; The mathematics without the mechanics: structures, generic arithmetic,
;; literals, derivatives, simplification, verdicts.

(require "error/uncompiled.rkt")
(tell-if-uncompiled)

(require "algebra/expression/write.rkt"
         "calculus/derivative.rkt" (except-in "calculus/gradient.rkt" gradient)
         "calculus/literal-function.rkt"
         "calculus/Taylor.rkt"
         "error/failure.rkt"
         "generic/arithmetic.rkt" "generic/compare.rkt" "generic/elementary.rkt"
         "generic/sums-and-products.rkt" "generic/predicates.rkt" "generic/rounding.rkt"
         (only-in "geometry/extended-names.rkt" commutator gradient)
         "lang/conditional.rkt" "lang/pattern/pattern.rkt"
         (only-in "numeric/constants.rkt" pi :pi :-pi :pi/2 :2pi golden-ratio)
         (except-in "value/assumptions.rkt"
                    assumptions-in-force call-assuming note-used! undeclared)
         "value/compose.rkt" (except-in "value/operator.rkt" commutator)
         "value/principal-value.rkt" "value/rewrite.rkt"
         "value/signature.rkt" "value/simplify.rkt" (except-in "value/structure.rkt" up down)
         (only-in "value/shape.rkt" typical-object)
         "value/complex.rkt" "value/vector.rkt"
         (except-in "value/matrix/linear-algebra.rkt" square-entries) "value/matrix/matrix.rkt"
         "value/matrix/quotient.rkt"
         (only-in "value/on-demand.rkt" characteristic-polynomial eigenvalues eigenvectors svd
                  polynomial-roots read-expression)
         "value/series/series-access.rkt" "value/series/calculus.rkt"
         "value/series/known-series.rkt"
         (only-in "value/series/series.rkt" series? power-series?)
         "verdict/equality.rkt" "verdict/prove-zero.rkt" "verdict/verdict.rkt")

(provide
 ;; binding forms with structure patterns
 define lambda λ case-lambda let let*
 ;; tests
 if cond and or not when unless
 ;; arithmetic
 (rename-out [g:+ +] [g:- -] [g:* *] [quotient-of /] [g:expt expt] [g:sqrt sqrt]
             [g:square square] [g:square sqr] [g:cube cube]
             [g:negate negate] [inverse-of invert]
             [g:exp exp] [g:log log] [g:abs abs]
             [g:sin sin] [g:cos cos] [g:tan tan] [g:sec sec] [g:csc csc] [g:cot cot]
             [g:asin asin] [g:acos acos] [g:atan atan]
             [g:sinh sinh] [g:cosh cosh] [g:tanh tanh]
             [g:sech sech] [g:csch csch] [g:coth coth]
             [g:asinh asinh] [g:acosh acosh] [g:atanh atanh] [g:sgn sgn] [g:erf erf]
             [g:exact->inexact exact->inexact] [g:inexact->exact inexact->exact]
             [g:magnitude magnitude] [g:number->string number->string]
             [g:floor floor] [g:ceiling ceiling] [g:truncate truncate] [g:round round])
 pi :pi :-pi :pi/2 :2pi golden-ratio principal-value
 make-rectangular make-polar real-part imag-part conjugate
 ;; comparison
 (rename-out [equal-by-proof? =] [g:< <] [g:> >] [g:<= <=] [g:>= >=]
             [zero-by-proof? zero?] [one-by-proof? one?]
             [g:positive? positive?] [g:negative? negative?]
             [g:max max] [g:min min] [g:add1 add1] [g:sub1 sub1]
             [g:number? number?] [g:real? real?] [g:rational? rational?]
             [g:integer? integer?] [g:exact? exact?] [g:inexact? inexact?]
             [g:symbol? symbol?] [g:equal? equal?] [g:eqv? eqv?]
             [g:memv memv] [g:member member] [g:case case])
 ;; sums and products over sequences
 (rename-out [g:for/sum for/sum] [g:for/product for/product]
             [g:for*/sum for*/sum] [g:for*/product for*/product])
 ;; structures
 up down up? down? structure? structure-orientation
 ref component s:length dimension
 (rename-out [tuple-vector-ref vector-ref] [tuple-vector-length vector-length]
             [tuple-vector->list vector->list] [tuple-vector-map vector-map])
 structure->vector structure->list vector->up vector->down list->up list->down
 s:generate s:map s:map/r s:fold flip
 compatible-shape compatible-zero typical-object zero-like
 dot-product inner-product outer-product cross-product euclidean-norm unequal-contraction
 ;; matrices and linear algebra
 matrix? matrix-by-rows matrix-by-columns m:generate identity-matrix
 up->column-matrix down->row-matrix column-matrix->up row-matrix->down
 matrix-ref m:num-rows m:num-cols m:dimension m:nth-row m:nth-col m:submatrix m:invert
 transpose determinant trace solve-linear-left solve-linear-right
 rank null-space characteristic-polynomial eigenvalues eigenvectors svd polynomial-roots
 s->m m->s s:inverse
 ;; functions and operators
 compose identity constant-function
 make-operator operator? (rename-out [I-operator I]) commutator anticommutator
 ;; literals
 literal-function literal-function? literal-up literal-down literal-number with-literals
 -> Real Any X X* UP UP* DOWN DOWN* Lagrangian Hamiltonian
 ;; series
 series power-series series:generate series:->function series? power-series? series:finite?
 series:ref series:head series:sum series:for-each partial-sums
 series:derivative series:integral series:reversion
 exp-series sin-series cos-series sinh-series cosh-series atan-series binomial-series
 ;; derivatives
 D partial Taylor-series Taylor-series-coefficients
 gradient jacobian Hessian-vector-product jacobian-vector-product vector-jacobian-product
 ;; expressions
 expression read-expression simplify substitute print-limit
 assume assuming assumptions forget-assumptions automatic-assumptions
 expand factor collect coefficient together apart numerator denominator
 ;; verdicts
 prove-zero verify-equal
 verdict? verdict-status verdict-residual verdict-witness verdict-value
 verdict-assumptions verdict-conditions verdict-alternatives verdict-factored verdict-kinks
 verdict-readings verdict-reason verdict-remarks proved? refuted? undecided?
 ;; failures
 exn:fail:mechanics exn:fail:mechanics?
 exn:fail:mechanics:singular exn:fail:mechanics:singular? exn:fail:mechanics:singular-where
 exn:fail:mechanics:singular:matrix exn:fail:mechanics:singular:matrix?
 exn:fail:mechanics:singular:matrix-null-vectors
 exn:fail:mechanics:not-convergent exn:fail:mechanics:not-convergent?
 exn:fail:mechanics:not-convergent-value exn:fail:mechanics:not-convergent-error-estimate
 exn:fail:mechanics:not-convergent:integral exn:fail:mechanics:not-convergent:integral?
 exn:fail:mechanics:not-convergent:integral-where)
