#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt")

@(define session (make-session))

@title[#:tag "failures"]{Failures}

A misuse raises @racket[exn:fail:contract]. A question that was well put and has no
answer, or none that could be found, raises one of these, which carry the data that
show why.

@defstruct*[(exn:fail:mechanics exn:fail) ()]{

What they have in common.

@examples[#:eval session
(with-handlers ([exn:fail:mechanics? exn-message])
  (definite-integral (lambda (t) (/ 1 t)) 0 1))]}

@defstruct*[(exn:fail:mechanics:singular exn:fail:mechanics) ([where any/c])]{

Something is not defined at @racket[where]: a point at which an integrand is not
finite, a matrix without an inverse.

@examples[#:eval session
(with-handlers ([exn:fail:mechanics:singular? exn:fail:mechanics:singular-where])
  (definite-integral (lambda (t) (/ 1 t)) -1 1))]}

@defstruct*[(exn:fail:mechanics:singular:matrix exn:fail:mechanics:singular)
            ([null-vectors (or/c list? #f)])]{

A matrix, @racket[where], has no inverse. @racket[null-vectors] are independent
values that it takes to zero, as @racket[null-space] finds them; @racket[#f] if they
are not known.

@examples[#:eval session
(eval:error (solve-linear-left (down (up 1 2) (up 2 4)) (up 1 1)))
(with-handlers ([exn:fail:mechanics:singular:matrix?
                 exn:fail:mechanics:singular:matrix-null-vectors])
  (solve-linear-left (down (up 1 2) (up 2 4)) (up 1 1)))]}

@defstruct*[(exn:fail:mechanics:not-convergent exn:fail:mechanics)
            ([value any/c] [error-estimate any/c])]{

An approximation did not reach its tolerance. @racket[value] is the best found,
@racket[error-estimate] says how far off it may be.

@examples[#:eval session
(with-handlers ([exn:fail:mechanics:not-convergent?
                 exn:fail:mechanics:not-convergent-value])
  (definite-integral (lambda (t) (/ 1 t)) 0 1))
(with-handlers ([exn:fail:mechanics:not-convergent?
                 exn:fail:mechanics:not-convergent-error-estimate])
  (definite-integral (lambda (t) (/ 1 t)) 0 1))]}

@defstruct*[(exn:fail:mechanics:not-convergent:integral exn:fail:mechanics:not-convergent)
            ([where real?])]{

An integral did not reach its tolerance. It comes with a number near the point at which the
integrand defies the
method: where it is infinite and the integral does not exist, as a rule.

@examples[#:eval session
(with-handlers ([exn:fail:mechanics:not-convergent:integral?
                 exn:fail:mechanics:not-convergent:integral-where])
  (definite-integral (lambda (x) (/ 1 (- (square x) 2))) 1 3))]}

@(close-session session)
