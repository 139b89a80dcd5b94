#lang scribble/manual
@(require (for-label mechanics racket/promise)
          "../eval.rkt" (only-in "../look/look.rkt" formula)
          "../next-pages.rkt")

@title[#:tag "differentiation"]{The computation of derivatives}

@(define session (make-session '(require racket/promise)))

You need not know any of this to use @racket[D]. It is told because the method is
short enough to be written down whole, and because it goes wrong in interesting
ways.

@section[#:tag "dual-numbers"]{A quantity whose square is zero}

Take a quantity @formula{ε} of which the square is zero, though @formula{ε} is not. Then
@formula{f(x + ε) = f(x) + f′(x) ε}, exactly: all further terms of the Taylor series
contain @formula{ε²}. So a derivative can be had by running the function itself on the
@emph{dual number} @formula{x + ε} and reading off the coefficient of @formula{ε}. Each elementary
operation knows what it does to dual numbers. For a product that is

@centered{@formula{(a + a′ ε) (b + b′ ε) = a b + (a′ b + a b′) ε},}

which is the product rule, and for @racket[sin] it is @formula{sin a + a′ cos a ε}. In general
an operation p of two arguments, with the partial derivatives p@subscript{0} and
p@subscript{1}, makes of them

@centered{p(a, b) + (p@subscript{0}(a, b) a′ + p@subscript{1}(a, b) b′) ε.}

That is the chain rule, once and for all, and it is all the library does with
derivatives. What an operation has to bring is its partial derivatives. They stand
beside it in one table, written in the library's own arithmetic:

@verbatim[#:indent 2]{
[sin (x) sin ((-4.0 4.0)) (g:cos x) ...]
[exp (x) exp ((-2.0 2.0)) value ...]
[* (a b) * ((-2.0 2.0) (-2.0 2.0)) b a ...]
}

An entry says how to compute with numbers, where to test, what the derivatives
are, and some other facts; @tt{value} is the value already computed. Since they are generic
code, they hold for numbers and symbols alike, and for dual numbers: hence second derivatives.

No formula is taken apart and no step size chosen. Loops, conditionals and recursion
in your function do no harm:

@examples[#:eval session #:label #f
(define (power x n)
  (if (= n 0) 1 (* x (power x (- n 1)))))
((D (lambda (x) (power x 10))) 'x)
((D (lambda (x) (power x 10))) 1.1)]

Nor do assignments, vectors, or early exits. It is your program that runs, on numbers
that happen to have two parts:

@examples[#:eval session #:label #f
(define (horner coefficients x)
  (let loop ([sum 0] [cs coefficients])
    (if (null? cs) sum (loop (+ (* sum x) (car cs)) (cdr cs)))))
((D (lambda (x) (horner '(3 0 -2 5) x))) 'x)
(define (root a)
  (let loop ([y 1.0])
    (define better (- y (/ (- (square y) a) (* 2 y))))
    (if (< (abs (- better y)) 1e-15) better (loop better))))
((D root) 2)
(/ 1 (* 2 (sqrt 2.0)))]

You never see a dual number. It exists while @racket[D] is at work.

@section[#:tag "higher-derivatives"]{Higher derivatives}

To take a second derivative, differentiate the derivative: the coefficients of the
outer ε are then dual numbers themselves, and each product of two of them takes
about four products of numbers. At order n it is 2ⁿ. For a function of a number
there is a better way. Let @formula{ε} be a quantity of which only the power n + 1 is zero,
and keep all coefficients up to εⁿ. Taylor's theorem, exact again, says that those
of f(x + ε) are the derivatives of f at x divided by factorials. A product takes
n²/2 products of coefficients,

@centered{c@subscript{k} = a@subscript{0}b@subscript{k} + a@subscript{1}b@subscript{k−1} +
⋯ + a@subscript{k}b@subscript{0},}

and the other operations no more. Take e = exp(a), of which one knows that e′ = e a′.
To compare coefficients in that equation gives

@centered{k e@subscript{k} = a@subscript{1}e@subscript{k−1} + 2a@subscript{2}e@subscript{k−2} +
⋯ + k a@subscript{k}e@subscript{0},}

each coefficient of e from those before it. An equation of this kind holds for
every operation that has a rule for its derivative, so that no operation needs to
be taught anything further. @racket[(expt D n)] works in this way, and so do power
series, which keep the coefficients for as long as you like.

@examples[#:eval session #:label #f
(define (h x) (/ (exp (sin x)) (+ 1 (square x))))
(((expt D 20) h) 1.25)
(series:ref ((Taylor-series h) 0) 20)]

@section[#:tag "perturbation-confusion"]{Nested derivatives and perturbation confusion}

When a derivative is taken inside a function that is itself being
differentiated, there are two ε at once. Consider

@examples[#:eval session #:label #f
(define (g x)
  (* x ((D (lambda (y) (+ x y))) 1)))]

The inner derivative, by y, is 1 whatever x is. So g(x) = x and g′ = 1:

@examples[#:eval session #:label #f
(g 'x)
(eval:check ((D g) 'x) 1)]

With a single ε for everything it comes out as 2. Watch how, with dual numbers
made by hand, as pairs of a value and a coefficient:

@examples[#:eval session #:label #f
(struct dual (value slope))
(define (add a b)
  (dual (+ (dual-value a) (dual-value b))
        (+ (dual-slope a) (dual-slope b))))
(define (multiply a b)
  (dual (* (dual-value a) (dual-value b))
        (+ (* (dual-value a) (dual-slope b))
           (* (dual-slope a) (dual-value b)))))
(define (naive-derivative f x)
  (dual-slope (f (dual x 1))))
(define (naive-g x)
  (multiply x (dual (naive-derivative (lambda (y) (add x y)) 1) 0)))
(eval:check (naive-derivative naive-g 3) 2)]

The outer call turns x into 3 + ε. The inner one turns y into 1 + ε, with the
same ε. Their sum 4 + 2ε has a coefficient to which x contributed, although x
was to be held fixed. This is called @emph{perturbation confusion}
(J. M. Siskind and B. A. Pearlmutter, 2005).

@section[#:tag "tags"]{Tags}

The cure is a fresh ε for each application of @racket[D], with a number of its own,
its @emph{tag}. The inner derivative then asks for the coefficient of its own ε and
leaves the other alone.

A number may now contain several ε. Think of it as a dual number in the youngest of
them, of which both parts are numbers, dual or not, in the older ones. Arithmetic
looks at the youngest ε first; what does not contain it is a constant to it:

@examples[#:eval session #:label #f
(struct tagged (tag value slope))
(define (tag-of a) (if (tagged? a) (tagged-tag a) 0))
(define (value-by tag a) (if (= (tag-of a) tag) (tagged-value a) a))
(define (slope-by tag a) (if (= (tag-of a) tag) (tagged-slope a) 0))
(define (plus a b)
  (define t (max (tag-of a) (tag-of b)))
  (if (= t 0)
      (+ a b)
      (tagged t (plus (value-by t a) (value-by t b))
              (plus (slope-by t a) (slope-by t b)))))
(define (times a b)
  (define t (max (tag-of a) (tag-of b)))
  (if (= t 0)
      (* a b)
      (tagged t (times (value-by t a) (value-by t b))
              (plus (times (value-by t a) (slope-by t b))
                    (times (slope-by t a) (value-by t b))))))
(define youngest 0)
(define (new-tag) (set! youngest (+ youngest 1)) youngest)
(define (derivative f x)
  (define t (new-tag))
  (slope-by t (f (tagged t x 1))))]

That is the whole of it, for a language of sums and products:

@examples[#:eval session #:label #f
(define (careful-g x)
  (times x (derivative (lambda (y) (plus x y)) 1)))
(eval:check (derivative careful-g 3) 1)
(define (cubed x) (times x (times x x)))
(eval:check (derivative (lambda (x) (derivative cubed x)) 5) 30)]

@section[#:tag "returned-functions"]{Functions that are returned}

There is a subtler trap. When the value of a function is again a function, the
coefficient cannot be read off at once; it must be read off from what that
function returns, when it is called one day. By then the same ε may have come
back in its argument. The classic example is the derivative of a shift:

@examples[#:eval session #:label #f
(define (shift x) (lambda (f) (lambda (y) (f (+ x y)))))
(define slope ((D shift) 0))
((slope cube) 'y)]

@racket[slope] takes a function f to its derivative f′. Applied twice it must
give the second derivative, and it does:

@examples[#:eval session #:label #f
((slope (slope cube)) 'y)
(eval:check ((slope (slope cube)) 3) 18)]

Our tagged numbers fail here. @racket[slope] was made by one application of the
derivative, so there is one tag, and both uses of @racket[slope] look for it:

@examples[#:eval session #:label #f
(define naive-slope
  (let ([t (new-tag)])
    (lambda (f)
      (lambda (y) (slope-by t (f (plus (tagged t 0 1) y)))))))
(eval:check ((naive-slope cubed) 3) 27)
(eval:check ((naive-slope (naive-slope cubed)) 3) 0)]

The outer use hands 3 + ε to the inner one, which adds its own ε, the same; it gets
3 + 2ε, and the coefficient in (3 + 2ε)³, 54, which it takes out. There is none left
for the outer use to find.

The library takes the ε out of such a function's values too, but before the function
runs it renames that ε, where it occurs in the arguments, to one that is nowhere else;
afterwards it renames it back. The inner use then finds its own ε and no other:

@centered{3 + ε@subscript{1}  ⟶  3 + ε@subscript{2};  (3 + ε@subscript{2} + ε@subscript{1})³ has the
coefficient 27 + 18 ε@subscript{2} of ε@subscript{1};
27 + 18 ε@subscript{2}  ⟶  27 + 18 ε@subscript{1},}

and the outer use finds 18. An argument may itself be a function, and carry an ε
that will show only in its values; to rename in a function is to rename in its
values, with its own arguments protected in the same manner. The problem and this
example are due to O. Manzyuk, B. A. Pearlmutter, A. A. Radul, D. R. Rush and
J. M. Siskind, @hyperlink["https://arxiv.org/abs/1211.4892"]{arXiv:1211.4892}.

@section[#:tag "carriers"]{Functions inside other values}

An argument may hold a function: a tuple, a list, a box, a hash table, a promise, a
parameter, a structure. Renaming goes in and finds it. Here h ↦ h′(3), used within
itself, computes @formula{∂²(x sin y)/∂x∂y} at (3, 3), which is cos 3, however h comes:

@examples[#:eval session #:label #f
(define (mixed pack unpack)
  (define slope-at-3
    ((D (lambda (x) (lambda (held) ((unpack held) x)))) 3))
  (slope-at-3
   (pack (lambda (x)
           (slope-at-3 (pack (lambda (y) (* x (sin y)))))))))
(cos 3)
(mixed identity identity)
(mixed box unbox)
(mixed (lambda (h) (delay h)) force)
(mixed (lambda (h) (hash 'h h)) (lambda (table) (hash-ref table 'h)))
(struct holder (h) #:transparent)
(mixed holder holder-h)]

There is one carrier that it cannot look into, a structure of a type that is opaque,
as Racket's are unless declared otherwise. Declare it @racket[#:transparent] if
functions travel in it.

A function may remember what it computed. That is safe as long as it looks its
arguments up by @racket[equal?], as hash tables do: a number that is being
differentiated is equal to none but itself, so that nothing is found under it that
was computed for another.

@examples[#:eval session #:label #f
(define (remembering f)
  (define known (make-hash))
  (lambda (x) (hash-ref! known x (lambda () (f x)))))
(define remembered (remembering cube))
(remembered 5)
((D remembered) 5)
((D (D remembered)) 5)]

To look up by @racket[=], or under a rounded number, is not: these see the value
only.

@next-pages["residuals" "what is left over, and whether it is zero"
            "guide-scales" "derivatives compiled"]

@(close-session session)
