#lang racket/base
;; Signatures of literal functions: `(-> (UP Real (UP* Real 2)) Real)`.
;;
;; A signature is written quoted or not: `->`, `X`, `UP` ... are procedures that
;; return the datum they stand for, `Real` is the symbol.  Parsed, a shape is
;; 'Real or a structure of shapes, so that shapes and values are walked alike
;; (SICM p. 31 and the appendix on notation).
;;
;; A count may be left open, as in (UP* Real): any number, which the argument fixes when
;; the function is applied.  One alone may then stand without a tuple, as the coordinate of
;; a system with one does; and in one tuple the open counts are the same number, so that
;; (Lagrangian) takes as many velocities as coordinates.

(require "../error/complain.rkt"
         "../generic/describe.rkt" "../generic/scalar.rkt" "../generic/up-down.rkt"
         "../generic/wrong-argument.rkt")

(provide
 ;; vocabulary
 -> Real Any X X* UP UP* DOWN DOWN* Lagrangian Hamiltonian
 ;; parsed form
 (struct-out signature) parse-signature default-signature signature-arity-mask
 first-misfit shape-fits? shape->datum)

;; domain : list of shapes, one an argument; or `several`, for any number of arguments.
;; range : a shape, or the signature of the functions that are the values.
(struct signature (domain range datum) #:authentic)

;; Any number, at least 1, of one shape.  kind : 'UP, 'DOWN or, of arguments, 'X
(struct several (kind shape) #:authentic)

;; ---------------------------------------------------------------------------
;; Vocabulary

(define Real 'Real)
(define Any 'Any)
(define (-> . parts) (cons '-> parts))
(define (X . shapes) (cons 'X shapes))
(define (UP . shapes) (cons 'UP shapes))
(define (DOWN . shapes) (cons 'DOWN shapes))
(define-syntax-rule (define-repeating name)
  (define name
    (case-lambda [(shape) (list 'name shape)]
                 [(shape n) (list 'name shape n)])))
(define-repeating X*)
(define-repeating UP*)
(define-repeating DOWN*)

;; A function of a local tuple with n coordinates; with as many as there are.
(define (Lagrangian [n #f])
  (define coordinates (tuple-shape 'Lagrangian UP* n))
  (-> (UP Real coordinates coordinates) Real))

;; A function of a Hamiltonian state with n coordinates and n momenta.  The momentum of one is
;; left open, which a number fits: so the signature says that it is none of a Lagrangian.
(define (Hamiltonian [n #f])
  (define coordinates (tuple-shape 'Hamiltonian UP* n))
  (define momenta (if (eqv? n 1) (DOWN* Real) (tuple-shape 'Hamiltonian DOWN* n)))
  (-> (UP Real coordinates momenta) Real))

(define (tuple-shape who make n)
  (unless (or (not n) (exact-positive-integer? n))
    (complain-of-argument who "a number of coordinates, a positive integer" n))
  (cond [(not n) (make Real)]
        [(= n 1) Real]
        [else (make Real n)]))

;; ---------------------------------------------------------------------------
;; Parsing

(define default-signature (signature '(Real) 'Real '(-> Real Real)))

(define (parse-signature d)
  (unless (and (list? d) (pair? d) (eq? (car d) '->) (= (length d) 3))
    (complain-showing
     'literal-function
     "a signature has the form (-> domain range), as in (-> (X Real Real) Real)"
     "given" (value->datum d)))
  (define domain (parse-domain (cadr d)))
  (when (null? domain) (raise-bad-shape (cadr d)))
  (signature domain (parse-range (caddr d)) d))

(define (parse-domain d)
  (cond [(not (pair? d)) (list (parse-shape d))]
        [else
         (case (car d)
           [(X) (map parse-shape (cdr d))]
           [(X* ^) (repeated d 'X list)]
           [else (list (parse-shape d))])]))

;; A structure of functions, or a function, needs its counts before it is applied.
(define (parse-range d)
  (cond [(and (pair? d) (eq? (car d) '->)) (parse-signature d)]
        [else
         (define range (parse-shape d))
         (when (open? range)
           (complain 'literal-function
                     "the range needs a count, as in (-> Real (UP* Real 2))\n  given: ~s" d))
         range]))

(define (open? shape)
  (cond [(several? shape) #t]
        [(structure? shape) (for/or ([s (in-vector (structure-elements shape))]) (open? s))]
        [else #f]))

(define (parse-shape d)
  (cond [(memq d '(Real Any)) d]
        [(pair? d)
         (case (car d)
           [(UP X) (apply up (map parse-shape (cdr d)))]
           [(DOWN) (apply down (map parse-shape (cdr d)))]
           [(UP* X* ^) (repeated d 'UP up)]
           [(DOWN*) (repeated d 'DOWN down)]
           [else (raise-bad-shape d)])]
        [else (raise-bad-shape d)]))

;; (UP* shape n), or with the count open, which `^` cannot leave
(define (repeated d kind make)
  (define parts (if (list? d) (length d) 0))
  (cond [(and (= parts 3) (exact-nonnegative-integer? (caddr d)))
         (define shape (parse-shape (cadr d)))
         (apply make (for/list ([_ (in-range (caddr d))]) shape))]
        [(and (= parts 2) (not (eq? (car d) '^))) (several kind (parse-shape (cadr d)))]
        [else (raise-bad-shape d)]))

(define (raise-bad-shape d)
  (complain-showing
   'literal-function
   (string-append "expected Real, (UP shape ...), (DOWN shape ...), (UP* shape n), (DOWN* shape n) "
                  "or, as a domain, (X shape ...)")
   "given" (value->datum d)))

;; ---------------------------------------------------------------------------
;; Shapes and values

;; Which numbers of arguments does the signature allow?
(define (signature-arity-mask s)
  (define domain (signature-domain s))
  (if (several? domain) -2 (arithmetic-shift 1 (length domain))))

;; The slot of the first argument that does not fit, and its shape; #f and #f where all do.
;; There are as many arguments as the signature allows.
(define (first-misfit s args)
  (define domain (signature-domain s))
  (let next ([shapes (if (several? domain) (map (lambda (_) (several-shape domain)) args) domain)]
             [args args] [slot 0])
    (cond [(null? shapes) (values #f #f)]
          [(shape-fits? (car shapes) (car args)) (next (cdr shapes) (cdr args) (add1 slot))]
          [else (values slot (car shapes))])))

(define (shape-fits? shape x)
  (cond [(eq? shape 'Any) (scalars? x)]
        [(eq? shape 'Real) (scalar? x)]
        [(several? shape) (or (shape-fits? (several-shape shape) x) (several-fit? shape x))]
        [(tuple? x)
         (define t (adopt x))
         (and (compatible? shape t)
              (for/and ([s (in-vector (structure-elements shape))]
                        [e (in-vector (structure-elements t))])
                (shape-fits? s e))
              (same-counts? shape t))]
        [else #f]))

(define (several-fit? shape x)
  (and (tuple? x)
       (if (eq? (several-kind shape) 'UP) (up? x) (down? x))
       (for/and ([e (in-vector (tuple-elements x))]) (shape-fits? (several-shape shape) e))
       (positive? (vector-length (tuple-elements x)))))

;; Do the components whose count is open have equal counts?
(define (same-counts? shape t)
  (define counts
    (for/list ([s (in-vector (structure-elements shape))]
               [e (in-vector (structure-elements t))]
               #:when (several? s))
      (count-of s e)))
  (or (null? counts) (andmap (lambda (n) (eqv? n (car counts))) (cdr counts))))

;; The number of components; 0 for a single value without a tuple.
(define (count-of s e)
  (if (shape-fits? (several-shape s) e) 0 (vector-length (tuple-elements e))))

;; Is x a scalar, or a tuple of scalars at any depth?
(define (scalars? x)
  (if (tuple? x)
      (for/and ([e (in-vector (tuple-elements x))]) (scalars? e))
      (scalar? x)))

(define (shape->datum shape)
  (cond [(several? shape)
         (list (case (several-kind shape) [(UP) 'UP*] [(DOWN) 'DOWN*] [else 'X*])
               (shape->datum (several-shape shape)))]
        [(structure? shape)
         (cons (if (up? shape) 'UP 'DOWN)
               (for/list ([s (in-vector (structure-elements shape))]) (shape->datum s)))]
        [else shape]))
