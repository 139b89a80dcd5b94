#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@(define session (make-session))

@title[#:tag "maps"]{Maps of the plane}

A map takes the two coordinates of a point and two procedures. It calls the first one with
the coordinates of the point's image, and the second one, without arguments, where there
is no image.

@examples[#:eval session #:label #f
(define ((standard-map K) theta I return fail)
  (let ((nI (+ I (* K (sin theta)))))
    (return ((principal-value :2pi) (+ theta nI))
            ((principal-value :2pi) nI))))
((standard-map 0.6) 1 1 list void)]

@defproc[(iterated-map [map (-> any/c any/c (-> any/c any/c any) (-> any) any)]
                       [n exact-nonnegative-integer?])
         (-> any/c any/c (-> any/c any/c any) (-> any) any)]{

The map that does @racket[map] @racket[n] times.

@examples[#:eval session
((iterated-map (standard-map 0.6) 10) 1 1 list void)
((iterated-map (standard-map 0.6) 1000000) 1 1 list void)]

Where it pays, @racket[map] is compiled, as by @racket[compile-function]: it is to compute
the image from the coordinates and to do nothing else. The values are the same but for
rounding, to which chaotic motion is sensitive. A map that takes decisions, or of which
points have no image, is called each time, and so is one that keeps exact numbers exact.
Anything but a map is an error, and so is an @racket[n] that is no natural number.

@sicm{4.3, p. 308}}
