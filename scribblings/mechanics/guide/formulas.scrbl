#lang scribble/manual
@(require (for-label mechanics mechanics/pict) "../eval.rkt" "../citation.rkt"
          "../next-pages.rkt")

@title[#:tag "guide-formulas"]{Mathematics that looks like mathematics}

@(define session (make-session))
@(define drawing (make-picture-session '(require mechanics/pict scribblings/mechanics/figure)))

What the prompt prints can be typed in again, and so it is an S-expression. For reading, for
a paper or for a page, any result can be had as a physicist would write it;
@secref["formulas"] has the details.

Here is a planet, in polar coordinates, and the equations that it obeys.

@examples[#:eval session #:label #f
(define (L-planet (up t (up r phi) (up rdot phidot)))
  (+ (* 1/2 'm (+ (square rdot) (square (* r phidot)))) (/ 'GMm r)))
(define orbit (up (literal-function 'r) (literal-function 'phi)))
(define equations (simplify (((Lagrange-equations L-planet) orbit) 't)))
equations]

@section{Formulas in a terminal}

@racket[->text] draws fractions and roots with characters, and breaks a long sum at its signs.
With @racket[print-expression] there is no need to simplify before.

@examples[#:eval session #:label #f
(display (->text equations))
(parameterize ([suppress-arguments '(t)])
  (print-expression equations #:as 'text))]

A verdict is typeset like anything else, and so is a derivation, step by step.

@examples[#:eval session #:label #f
(print-expression (verify-equal (sqrt (square 'x)) 'x) #:as 'text)
(show-derivation
 (derive-Legendre-transform L-planet (up 't (up 'r 'phi) (down 'p_r 'p_phi)))
 #:as 'text)]

@section{Formulas on one line}

@racket[->infix] is for messages, labels and logs. What it writes can be read: so a formula
from a mail is a value again.

@examples[#:eval session #:label #f
(->infix (simplify (L-planet (up 't (up 'r 'phi) (up 'rdot 'phidot)))))
(define T (read-infix "½ m (ṙ² + r² φ̇²)"))
T]

@section{Formulas for papers and pages}

@racket[->TeX] gives what stands between @tt{\[} and @tt{\]} in LaTeX with @tt{amsmath},
@racket[->MathML] what a browser shows by itself.

@examples[#:eval session #:label #f
(display (->TeX equations))
(define page (string-append "<p>The kinetic energy is " (->MathML T #:inline? #t) ".</p>"))
(substring page 0 78)]

@section{Formulas as pictures}

@racket[->pict] of @racketmodname[mechanics/pict #:indirect] makes pictures, to be scaled,
colored and put together with others: on slides, beside a plot, in a document like this.

@picture-examples[drawing
(eval:alts (->pict (/ (square 'p_phi) (* 2 'm (square 'r))) #:size 20)
           (figure (->pict (/ (square 'p_phi) (* 2 'm (square 'r))) #:size 20)))
(eval:alts (->pict (((expt D 2) (literal-function 'theta)) 't) #:size 20)
           (figure (->pict (((expt D 2) (literal-function 'theta)) 't) #:size 20)))]

@next-pages["guide-showing" "a program as a page or a paper"
            "typeset-results" "formulas in DrRacket and at the prompt"
            "formulas" "every name about formulas"]

@(close-session session)
@(close-session drawing)
