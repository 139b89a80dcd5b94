#lang racket/base
;; Signatures of literal functions: `(-> (UP Real (UP* Real 2)) Real)`.
;;
;; A signature is written quoted or not: `->`, `X`, `UP` ... are procedures that
;; return the datum they stand for, `Real` is the symbol.  Parsed, a shape is
;; 'Real or a structure of shapes, so that shapes and values are walked alike
;; (SICM p. 31 and the appendix on notation).

(require "../generic/describe.rkt" "../generic/scalar.rkt" "../generic/up-down.rkt")

(provide
 ;; vocabulary
 -> Real Any X X* UP UP* DOWN DOWN* Lagrangian Hamiltonian
 ;; parsed form
 (struct-out signature) parse-signature default-signature
 shape-fits? shape->datum)

;; domain : list of shapes, one an argument.  range : a shape.
(struct signature (domain range datum) #:authentic)

;; ---------------------------------------------------------------------------
;; Vocabulary

(define Real 'Real)
(define Any 'Any)
(define (-> . parts) (cons '-> parts))
(define (X . shapes) (cons 'X shapes))
(define (UP . shapes) (cons 'UP shapes))
(define (DOWN . shapes) (cons 'DOWN shapes))
(define (X* shape n) (list 'X* shape n))
(define (UP* shape n) (list 'UP* shape n))
(define (DOWN* shape n) (list 'DOWN* shape n))

;; A function of a local tuple with n coordinates.
(define (Lagrangian [n 1])
  (define coordinates (tuple-shape 'Lagrangian UP* n))
  (-> (UP Real coordinates coordinates) Real))

;; A function of a Hamiltonian state with n coordinates and n momenta.
(define (Hamiltonian [n 1])
  (-> (UP Real (tuple-shape 'Hamiltonian UP* n) (tuple-shape 'Hamiltonian DOWN* n)) Real))

(define (tuple-shape who make n)
  (unless (exact-positive-integer? n)
    (raise-argument-error who "a number of coordinates, a positive integer" n))
  (if (= n 1) Real (make Real n)))

;; ---------------------------------------------------------------------------
;; Parsing

(define default-signature (signature '(Real) 'Real '(-> Real Real)))

(define (parse-signature d)
  (unless (and (list? d) (pair? d) (eq? (car d) '->) (= (length d) 3))
    (raise-arguments-error
     'literal-function
     "a signature has the form (-> domain range), as in (-> (X Real Real) Real)"
     "given" (value->datum d)))
  (define domain (parse-domain (cadr d)))
  (when (null? domain) (raise-bad-shape (cadr d)))
  (signature domain (parse-shape (caddr d)) d))

(define (parse-domain d)
  (cond [(and (pair? d) (eq? (car d) 'X)) (map parse-shape (cdr d))]
        [(and (pair? d) (eq? (car d) 'X*)) (repeat d)]
        [else (list (parse-shape d))]))

(define (parse-shape d)
  (cond [(memq d '(Real Any)) d]
        [(pair? d)
         (case (car d)
           [(UP X) (apply up (map parse-shape (cdr d)))]
           [(DOWN) (apply down (map parse-shape (cdr d)))]
           [(UP* X*) (apply up (repeat d))]
           [(DOWN*) (apply down (repeat d))]
           [else (raise-bad-shape d)])]
        [else (raise-bad-shape d)]))

(define (repeat d)
  (unless (and (= (length d) 3) (exact-nonnegative-integer? (caddr d)))
    (raise-bad-shape d))
  (define shape (parse-shape (cadr d)))
  (for/list ([_ (in-range (caddr d))]) shape))

(define (raise-bad-shape d)
  (raise-arguments-error
   'literal-function
   (string-append "expected Real, (UP shape ...), (DOWN shape ...), (UP* shape n), (DOWN* shape n) "
                  "or, as a domain, (X shape ...)")
   "given" (value->datum d)))

;; ---------------------------------------------------------------------------
;; Shapes and values

(define (shape-fits? shape x)
  (cond [(eq? shape 'Any) (scalars? x)]
        [(eq? shape 'Real) (scalar? x)]
        [(tuple? x)
         (define t (adopt x))
         (and (compatible? shape t)
              (for/and ([s (in-vector (structure-elements shape))]
                        [e (in-vector (structure-elements t))])
                (shape-fits? s e)))]
        [else #f]))

;; A scalar, or a tuple of such at any depth.
(define (scalars? x)
  (if (tuple? x)
      (for/and ([e (in-vector (tuple-elements x))]) (scalars? e))
      (scalar? x)))

(define (shape->datum shape)
  (if (structure? shape)
      (cons (if (up? shape) 'UP 'DOWN)
            (for/list ([s (in-vector (structure-elements shape))]) (shape->datum s)))
      shape))
