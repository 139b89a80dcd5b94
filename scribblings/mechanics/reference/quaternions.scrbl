#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-quaternions"]{Quaternions}

@(define session
   (make-session '(define q (quaternion 'a 'b 'c 'd))
                 '(define p (quaternion 0.1 0.7 0.5 0.5))))

A @emph{quaternion} r + x i + y j + z k has a real part r and a vector part (x, y, z). The
units obey i² = j² = k² = i j k = −1, so that products depend on the order of their factors.
The parts are scalars. @racket[+], @racket[-], @racket[*], @racket[/], @racket[expt] with
integers, @racket[exp], @racket[magnitude], @racket[conjugate] and @racket[invert] take
quaternions; a scalar counts as the one without a vector part. A quotient @racket[(/ p q)] is
p times the inverse of q, from the right.

@section{Constructors and parts of quaternions}

@deftogether[(@defproc[(quaternion [r scalar] [x scalar] [y scalar] [z scalar]) quaternion?]
              @defproc[(make-quaternion [parts (or/c tuple list?)]) quaternion?]
              @defproc[(real&3vector->quaternion [r scalar] [v tuple]) quaternion?])]{

The quaternion of four parts, of a tuple of all four, or of the real part and a tuple of
the three others.

@examples[#:eval session
(* (quaternion 0 1 0 0) (quaternion 0 0 1 0))
(make-quaternion (up 'a 'b 'c 'd))
(* (real&3vector->quaternion 0 (up 'x 'y 'z)) (quaternion 0 0 0 1))
(verify-equal (* q (/ 1 q)) 1)
(eval:error (* q (up 1 2 3)))]

@sicm{2.12, pp. 183 and 187}}

@defproc[(quaternion? [v any/c]) boolean?]{

Is a value a quaternion?

@examples[#:eval session
(quaternion? q)
(quaternion? (up 1 2 3 4))]}

@deftogether[(@defproc[(quaternion->vector [q quaternion?]) structure?]
              @defproc[(quaternion->3vector [q quaternion?]) structure?]
              @defproc[(quaternion->real-part [q quaternion?]) scalar]
              @defproc[(quaternion-ref [q quaternion?] [i exact-nonnegative-integer?]) scalar])]{

All four parts as an @racket[up], the vector part as an @racket[up], the real part, and the
part of number i, from 0.

@examples[#:eval session
(quaternion->vector q)
(quaternion->3vector q)
(quaternion->real-part q)
(quaternion-ref q 3)]

@sicm{2.12, pp. 183–185}}

@deftogether[(@defproc[(q:conjugate [q quaternion?]) quaternion?]
              @defproc[(q:magnitude [q quaternion?]) scalar]
              @defproc[(q:make-unit [q quaternion?]) quaternion?])]{

The quaternion with its vector part turned round, the root of the sum of the squares of all
parts, and the quaternion divided by that.

@examples[#:eval session
(q:conjugate q)
(q:magnitude q)
(verify-equal (q:magnitude (* q q)) (square (q:magnitude q)))
(q:make-unit (quaternion 1 1 1 1))]}

@section{Quaternions as rotations}

The quaternion of a rotation by the angle θ about the unit vector n has the real part
cos ½θ and the vector part n sin ½θ. q and −q are the same rotation.

@deftogether[(@defproc[(angle-axis->quaternion [theta scalar] [axis tuple]) quaternion?]
              @defproc[(quaternion->angle-axis [q quaternion?] [continue procedure? list]) any])]{

From an angle and an axis of length 1 to a quaternion, and back. The second calls
@racket[continue] with the two.

@examples[#:eval session
(angle-axis->quaternion 'theta (up 0 0 1))
(quaternion->angle-axis (angle-axis->quaternion 0.5 (up 0 0.6 0.8)))]

@sicm{2.12, p. 184}}

@deftogether[(@defproc[(quaternion->rotation-matrix [q quaternion?]) matrix?]
              @defproc[(quaternion->RM [q quaternion?]) matrix?]
              @defproc[(rotation-matrix->quaternion [M matrix?]) quaternion?])]{

The matrix of the rotation, by products of the parts and by angle and axis, and a quaternion
of a matrix, which is refused if it can be seen not to be a rotation. Of a matrix of numbers
it is the one whose greatest part is positive; a matrix of symbols is taken for a rotation by
less than half a turn.

@examples[#:eval session
(matrix-ref (quaternion->rotation-matrix q) 0 1)
(quaternion->RM (angle-axis->quaternion 0.5 (up 0 0 1)))
(rotation-matrix->quaternion (Rz-matrix 0.5))
(define r (quaternion 'r 'x 'y 'z))
(verify-equal (quaternion->rotation-matrix (* q r))
              (* (quaternion->rotation-matrix q)
                 (quaternion->rotation-matrix r)))]

@sicm{2.12, pp. 184 and 185}}

@defproc[((q:rotate [q quaternion?]) [v tuple]) structure?]{

Turns a vector by a quaternion of length 1: the vector part of q v q*.

@examples[#:eval session
((q:rotate (angle-axis->quaternion (/ pi 2) (up 0 0 1))) (up 1. 0 0))]}

@section{Quaternions as matrices}

@deftogether[(@defthing[q:i matrix?]
              @defthing[q:j matrix?]
              @defthing[q:k matrix?])]{

The units as 4 by 4 matrices, which act on the tuple of a quaternion's parts.

@examples[#:eval session
(* q:i (up 'a 'b 'c 'd))
(* q:j (up 'a 'b 'c 'd))
(* q:k (up 'a 'b 'c 'd))
(verify-equal (* q:i q:j) q:k)]

@sicm{2.12, p. 186}}

@deftogether[(@defproc[(quaternion->4x4 [q quaternion?]) matrix?]
              @defproc[(4x4->quaternion [M matrix?]) quaternion?])]{

The quaternion as such a matrix, and the quaternion in the first row of one. Products agree.

@examples[#:eval session
(quaternion->4x4 q)
(4x4->quaternion (* q:i q:j))]}

@(close-session session)
