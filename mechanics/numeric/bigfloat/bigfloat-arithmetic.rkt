#lang racket/base
;; Floating-point numbers of any precision: those of math/bigfloat, with the
;; operations under the names that programs and generic arithmetic have for them.
;;
;; They compute in libmpfr, a library that Racket does not bring with it on every
;; system.  Results are rounded to the precision in force, `bf-precision`.

(require math/bigfloat
         "../../error/machine-limits.rkt"
         "../../operation/operation-column.rkt")

(provide check-bigfloats
         with-bits
         operation-on-bigfloats
         real->bigfloat         ; rounded to the precision in force
         exact-value)

;; add : fails where the library is missing
(define (check-bigfloats who [add bf+])
  (with-handlers ([no-function? (lambda (e) (raise-no-library who))])
    (add (bf 1) (bf 2))
    (void)))

;; A foreign function that was not found says so by `error`, as a failure of no kind of its own.
(define (no-function? e) (and (exn:fail? e) (not (exn:fail:contract? e))))

(define (raise-no-library who)
  (raise-unavailable
   who
   (string-append
    "numbers of higher precision need the library MPFR, which is not installed"
    "\n  Debian, Ubuntu: apt install libmpfr6"
    "\n  Fedora: dnf install mpfr; Arch: pacman -S mpfr"
    "\n  macOS, Windows: Racket's package math-lib brings it: raco pkg install math-lib")))

;; The value of the body, computed with this number of bits.
(define-syntax-rule (with-bits bits body ...) (call-with-bits bits (lambda () body ...)))

(define (call-with-bits bits f)
  (if (eqv? bits (bf-precision))
      (f)
      (parameterize ([bf-precision bits]) (f))))

;; A fraction; of infinities and not-a-number, which have no exact value, the flonum.
(define (exact-value x)
  (if (bfrational? x) (bigfloat->rational x) (bigfloat->flonum x)))

;; ---------------------------------------------------------------------------

(define (square x) (bf* x x))
(define (cube x) (bf* x (bf* x x)))

(define-column functions
  [sqrt bfsqrt] [exp bfexp] [log bflog] [abs bfabs] [sgn bfsgn] [erf bferf]
  [sin bfsin] [cos bfcos] [tan bftan] [asin bfasin] [acos bfacos] [atan bfatan] [atan2 bfatan2]
  [sinh bfsinh] [cosh bfcosh] [tanh bftanh] [asinh bfasinh] [acosh bfacosh] [atanh bfatanh]
  [+ bf+] [- bf-] [* bf*] [/ bf/] [expt bfexpt] [negate bf-] [square square] [cube cube])

;; The names that programs have for arithmetic.
(define operations
  (hash-set* functions 'add bf+ 'subtract bf- 'multiply bf* 'divide bf/))

;; The operation of this name on one or two bigfloats, or #f.
(define (operation-on-bigfloats name arguments)
  (hash-ref operations (operation-key name arguments) #f))
