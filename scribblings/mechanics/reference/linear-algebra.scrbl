#lang scribble/manual
@(require (for-label mechanics) "../eval.rkt" "../citation.rkt")

@title[#:tag "reference-linear"]{Matrices and linear algebra}

@(define session (make-session))

A @emph{matrix} is a rectangle of scalars with the matrix product. It multiplies
an @racket[up] from the left and a @racket[down] from the right. A structure of
structures can stand for a linear map as well; where the book means a matrix,
such a structure is accepted, its components being the rows.

A matrix of functions is applied as the function whose value is the matrix of their values.

@examples[#:eval session ((matrix-by-rows (list sin cos) (list exp square)) 't)]

Indices of rows and columns start at 0.

@section{Constructors of matrices}

@deftogether[(@defproc[(matrix-by-rows [row (or/c list? tuple)] ...+) matrix?]
              @defproc[(matrix-by-columns [column (or/c list? tuple)] ...+) matrix?])]{

All rows must have one length.

@examples[#:eval session
(define R (matrix-by-rows (list (cos 'a) (- (sin 'a)))
                          (list (sin 'a) (cos 'a))))
(* R (up 'x 'y))
(* R R)
(matrix-by-columns '(1 2) '(3 4))]

@sicm{2.7, p. 139}}

@defproc[(m:generate [rows exact-nonnegative-integer?]
                     [columns exact-nonnegative-integer?]
                     [f procedure?]) matrix?]{

The matrix with the entries @racket[(f i j)].

@examples[#:eval session (m:generate 2 3 (lambda (i j) (+ i j)))]}

@defproc[(identity-matrix [n exact-positive-integer?]) matrix?]{

The matrix of n rows that changes nothing.

@examples[#:eval session (identity-matrix 2)]}

@deftogether[(@defproc[(up->column-matrix [s tuple]) matrix?]
              @defproc[(down->row-matrix [s tuple]) matrix?]
              @defproc[(column-matrix->up [m matrix?]) structure?]
              @defproc[(row-matrix->down [m matrix?]) structure?])]{

Between tuples and matrices of one column or one row.

@examples[#:eval session
(up->column-matrix (up 'x 'y))
(down->row-matrix (down 'x 'y))
(row-matrix->down (matrix-by-rows '(1 2)))
(column-matrix->up (matrix-by-columns '(1 2)))]}

@section{Parts of matrices}

@defproc[(matrix? [x any]) boolean?]{

Is @racket[x] a matrix? A structure of structures is none.

@examples[#:eval session (matrix? (identity-matrix 2)) (matrix? (up (up 1 0) (up 0 1)))]}

@deftogether[(@defproc[(matrix-ref [m matrix?] [i exact-nonnegative-integer?]
                                      [j exact-nonnegative-integer?]) scalar]
              @defproc[(m:nth-row [m matrix?] [i exact-nonnegative-integer?]) structure?]
              @defproc[(m:nth-col [m matrix?] [j exact-nonnegative-integer?]) structure?])]{

An entry; a row, as a @racket[down]; a column, as an @racket[up].

@examples[#:eval session
(define M (matrix-by-rows '(a b) '(c d)))
(matrix-ref M 0 1)
(m:nth-row M 1)
(m:nth-col M 1)
(eval:error (matrix-ref M 2 0))]}

@deftogether[(@defproc[(m:num-rows [m matrix?]) exact-nonnegative-integer?]
              @defproc[(m:num-cols [m matrix?]) exact-nonnegative-integer?]
              @defproc[(m:dimension [m matrix?]) exact-nonnegative-integer?])]{

The numbers of rows and of columns. @racket[m:dimension] is that of a square matrix, and an
error for others.

@examples[#:eval session
(m:num-rows (matrix-by-rows '(1 2 3)))
(m:num-cols (matrix-by-rows '(1 2 3)))
(m:dimension M)]}

@defproc[(m:submatrix [m matrix?]
                      [low-row exact-nonnegative-integer?] [high-row exact-nonnegative-integer?]
                      [low-column exact-nonnegative-integer?]
                      [high-column exact-nonnegative-integer?])
         matrix?]{

Rows and columns from the low index up to, but without, the high one.

@examples[#:eval session
(m:submatrix (m:generate 3 3 (lambda (i j) (+ (* 3 i) j))) 0 2 1 3)]}

@section{Linear algebra}

@deftogether[(@defproc*[([(transpose [m value]) value]
                         [(transpose [m tuple] [right tuple]) value])])]{

Rows and columns exchanged, of a matrix, or of a structure of structures, in which the two
levels exchange places; a tuple of scalars changes its orientation. With two arguments,
@racket[m] is seen as the map from @racket[right] to
@racket[(* m right)], and the result is the structure of the transposed map.

@examples[#:eval session
(transpose M)
(transpose (down (up 'a 'b) (up 'c 'd)))
(transpose (up 'x 'y))
(transpose (down (up 'a 'b) (up 'c 'd)) (up 'x 'y))]

@sicm{5.2, p. 351}}

@deftogether[(@defproc[(determinant [m value]) scalar]
              @defproc[(trace [m value]) scalar])]{

The determinant of a square matrix or a square structure of structures.

@examples[#:eval session
(determinant M)
(determinant (down (down 'a 'b) (down 'b 'c)))
(trace M)]

Zeros are used: a matrix that falls into blocks costs what its blocks cost. Exact
numbers stay exact, and expressions are not divided by expressions that might be
zero.

@examples[#:eval session
(determinant (m:generate 8 8 (lambda (i j) (/ 1 (+ i j 1)))))
(factor (determinant (matrix-by-rows (list 1 'x (square 'x))
                                     (list 1 'y (square 'y))
                                     (list 1 'z (square 'z)))))]

@sicm{2.8.1, p. 144}}

@deftogether[(@defproc[(solve-linear-left [A value] [b value]) value]
              @defproc[(solve-linear-right [b value] [A value]) value])]{

The x for which @racket[(* A x)], or @racket[(* x A)], is b. For a matrix A, b is
an up tuple on the left and a down tuple on the right, or a matrix, which is
solved for column by column, or row by row. Tuples may be nested to any depth.
Functions, either or both, give the function of the solutions for their values.

@examples[#:eval session
(solve-linear-left (down (down 'a 0) (down 0 'b)) (down 'p 'q))
(solve-linear-left M (up 1 0))
(solve-linear-right (down 1 0) M)]

A matrix without an inverse raises @racket[exn:fail:mechanics:singular:matrix],
which says which rows depend on others, what the matrix takes to zero, and whether
the system has solutions all the same. An entry or a determinant that is zero only
after simplification is zero. Flonums are known to a rounding error each: a matrix
of them has no inverse if changes of that size may take it away.

@examples[#:eval session
(eval:error (solve-linear-left (matrix-by-rows '(1 2) '(2 4)) (up 1 0)))
(eval:error (solve-linear-left (down (down (square (cos 'q)) (- 1 (square (sin 'q))))
                                     (down 'm 'm))
                               (down 'p 'p)))
(eval:error (solve-linear-left (matrix-by-rows '(0.1 0.3) '(0.3 0.9)) (up 1 2)))]

@sicm{1.7, p. 71}}

@defproc[(m:invert [m matrix?]) matrix?]{

The inverse, also @racket[(/ 1 m)].

@examples[#:eval session (m:invert M)]}

@defproc[(rank [A value]) exact-nonnegative-integer?]{

How many rows of a matrix, or components of a structure of structures, are
independent. Entries are numbers or expressions; these at a generic point, where
only what is identically zero is zero. Matrices need not be square.

@examples[#:eval session
(rank (matrix-by-rows '(a b) '(c d)))
(rank (matrix-by-rows '(1 2 3) '(2 4 6)))]}

@defproc[(null-space [A value]) (listof value)]{

Independent values of x for which @racket[(* A x)] is zero, such that all others
are combinations of them: for a mass matrix, the directions of velocity without
inertia. For the rotation by @math{θ} about an axis it finds the axis.

@examples[#:eval session
(null-space (matrix-by-rows '(1 2 3) '(2 4 6)))
(null-space (down (down 'm 'm) (down 'm 'm)))
(null-space (- (matrix-by-rows (list (cos 'theta) 0 (sin 'theta))
                               (list 0 1 0)
                               (list (- (sin 'theta)) 0 (cos 'theta)))
               1))]}

@defproc[(characteristic-polynomial [m value] [x value]) value]{

The determinant of @racket[(- x m)] as a polynomial in x, which may be a matrix
too: every matrix satisfies its characteristic polynomial.

@examples[#:eval session
(characteristic-polynomial M 'x)
(characteristic-polynomial M M)]}

@defproc[(eigenvalues [m value]) (listof scalar)]{

The zeros of the characteristic polynomial, each as often as it is one. Matrices of
finite real numbers, some of them flonums, may have any size; their eigenvalues come in
the order of real parts, as accurate as LAPACK's; a note names those of which roundings leave
fewer than half of the digits, as of eigenvalues that are repeated. Otherwise the zeros of the
matrix must leave blocks of at most two rows; real eigenvalues of exact numbers are exact.

@examples[#:eval session
(eigenvalues (matrix-by-rows '(2 1) '(1 2)))
(eigenvalues (matrix-by-rows '(1 1) '(1 0)))
(eigenvalues (matrix-by-rows '(0 1) (list (- (square 'omega)) 0)))
(eigenvalues (matrix-by-rows '(a b c) '(0 d e) '(0 0 f)))
(eigenvalues (matrix-by-rows '(2.0 -1 0) '(-1 2 -1) '(0 -1 2)))]

An area-preserving map is stable at a fixed point if the eigenvalues of its
derivative there have magnitude 1 @sicm{4.1}.}

@defproc[(eigenvectors [m value]) (listof list?)]{

For each eigenvalue a list: the eigenvalue, and after it its independent eigenvectors, as
@racket[up] tuples. Of exact numbers, real eigenvalues and their vectors are exact; a complex one
that is irrational is a decimal with all digits, and the greatest component of its vectors is 1.
Those of flonums have unit length. If such a matrix is symmetric, each eigenvalue comes with one
vector, orthogonal to all others; if it is not, eigenvalues that are the same but for
roundings are one, with their mean as value. A note names vectors of which roundings leave fewer
than half of the digits, since another eigenvalue is near.

@examples[#:eval session
(eigenvectors (matrix-by-rows '(a b) '(b a)))
(eigenvectors (matrix-by-rows '(2 1) '(1 3)))
(eigenvectors (matrix-by-rows '(2.0 1.0) '(1.0 2.0)))
(eigenvectors (matrix-by-rows '(2.0 0.0 0.0) '(0.0 2.0 0.0) '(0.0 1.0 2.0)))
(eval:error (eigenvectors 3))]}

@defproc[(svd [m value]) list?]{

The singular value decomposition U Σ Vᵀ of a matrix of real numbers: the list of U, the
singular values from the greatest on, and V. The columns of U and V have unit length and
are orthogonal, those of singular values 0 included.

@examples[#:eval session
(svd (matrix-by-rows '(3 0) '(4 5)))
(svd (matrix-by-rows '(3 0) '(4 0)))
(eval:error (svd (matrix-by-rows '(a b))))]}

@defproc[(polynomial-roots [p scalar] [x symbol?]) (listof scalar)]{

The roots of a polynomial in x, each as often as it is one: exact where they are rational,
and of a polynomial of degree 2; of higher degree, decimals, for which its coefficients must
be numbers. All digits of decimals are right, however many roots there are and however near one
another; but those that coefficients in decimals leave uncertain in more than half of their digits
a note names.

@examples[#:eval session
(polynomial-roots (+ (* 'a (square 'x)) (* 'b 'x)) 'x)
(polynomial-roots (* (- 'x 1) (- 'x 1/2) (+ (square 'x) 4)) 'x)
(polynomial-roots (- (expt 'x 3) 2) 'x)
(polynomial-roots (apply * (for/list ([k 20]) (- 'x k 1))) 'x)
(eval:error (polynomial-roots (sin 'x) 'x))]}

@deftogether[(@defproc[(s->m [left tuple] [m tuple] [right tuple]) matrix?]
              @defproc[(m->s [left tuple] [m matrix?] [right tuple]) structure?])]{

The matrix of the bilinear form @racket[(* left (* m right))] in the scalars of
@racket[left] and @racket[right], and the structure that has a given matrix. Of
@racket[left] and @racket[right] only the shapes count.

@examples[#:eval session
(define S (down (up 'a 'b) (up 'c 'd)))
(s->m (down 1 1) S (up 1 1))
(m->s (down 1 1) (s->m (down 1 1) S (up 1 1)) (up 1 1))]

@sicm{5.2, p. 353}}

@defproc[(s:inverse [left tuple] [m tuple] [right tuple]) structure?]{

The structure that undoes the map from @racket[right] to @racket[(* m right)].

@examples[#:eval session
(* (s:inverse (down 1 1) S (up 1 1)) (* S (up 'x 'y)))]}

@(close-session session)
