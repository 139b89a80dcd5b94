#lang racket/base
;; From programs to machine code, by the compiler of Racket.
;;
;; A program becomes the body of a *linklet*, the form below modules that Racket
;; hands to its compiler: it knows the primitives and nothing of macros, so that
;; compiling costs a few milliseconds per hundred instructions.  Within one
;; procedure the compiler keeps flonums unboxed.
;;
;; It interprets procedures, though, that are larger than a limit.  So the instructions are
;; divided into *sections*, each a closed procedure of its own, between which systems of
;; equations are solved; a value that another section, a system or an output needs is stored in the
;; flvector of all values (closures.rkt).

(require racket/linklet
         racket/list
         "flonum-functions.rkt" "closures.rkt" "program.rkt")

(provide (protect-out program->maker))

;; -> (-> (input output -> void)), which makes procedures from one flvector into
;; another, to be used by one thread at a time each.
(define (program->maker p)
  (define parts (divide p))
  (if (at-once? p parts)
      (let ([run (car (compile-procedures p (list (whole->procedure p))))]) (lambda () run))
      (sections->maker p parts)))

;; A short program needs no flvector of all values.
(define (at-once? p parts)
  (and (= 1 (length parts))
       (section? (car parts))
       (<= (vector-length (program-outputs p)) most-outputs)))

(define most-outputs 100)

(define (sections->maker p parts)
  (define sections (filter section? parts))
  (define in-memory (values-in-memory p parts))
  (define procedures
    (for/hasheq ([s (in-list sections)]
                 [f (in-list (compile-procedures
                              p (for/list ([s (in-list sections)])
                                  (section->procedure p s in-memory))))])
      (values s f)))
  (define (steps place-of)
    (for/list ([part (in-list parts)])
      (or (hash-ref procedures part #f) (system-step p part place-of))))
  (steps->runner-maker p steps))

;; ---------------------------------------------------------------------------
;; Sections

;; Instructions whose places are from `start` on and before `end`.
(struct section (start end) #:authentic)

;; Racket interprets a procedure of more than 10,000 symbols, numbers and ends of lists, and fails
;; if there is a sine in it.
(define longest-form 7500)

;; -> list of sections and, between them, places of systems
(define (divide p)
  (define end (+ (program-inputs p) (program-length p)))
  (define (operation k) (and (< k end) (instruction-operation (instruction-at p k))))
  (let loop ([k (program-inputs p)])
    (case (operation k)
      [(#f) '()]
      [(solve) (cons k (loop (+ k 1)))]
      [(component) (loop (+ k 1))]
      [else
       (define next (end-of-section p k end))
       (cons (section k next) (loop next))])))

;; The place where the form gets too long, or a system comes.
(define (end-of-section p start end)
  (let loop ([k start] [length 0])
    (cond [(or (= k end) (eq? 'solve (instruction-operation (instruction-at p k)))) k]
          [else
           (define longer (+ length (length-of-form (instruction-at p k))))
           (if (and (> longer longest-form) (> k start)) k (loop (+ k 1) longer))])))

;; At most, with the operands loaded and the value stored.
(define (length-of-form i)
  (define operands (instruction-operands i))
  (define loads (* 10 (count place? operands)))
  (if (eq? 'wrapped (instruction-operation i))
      (+ 80 loads)
      (+ 13 loads (length operands))))

;; place -> #t, where a value is an output, or needed outside its section
(define (values-in-memory p parts)
  (define needed (make-hasheqv))
  (define (need! operand before)
    (when (and (place? operand) (< (place-index operand) before))
      (hash-set! needed (place-index operand) #t)))
  (for ([o (in-vector (program-outputs p))]) (need! o +inf.0))
  (for* ([part (in-list parts)]
         [start (in-value (if (section? part) (section-start part) part))]
         [k (in-range start (if (section? part) (section-end part) (+ part 1)))]
         [operand (in-list (instruction-operands (instruction-at p k)))])
    (need! operand start))
  needed)

;; ---------------------------------------------------------------------------
;; The linklet

;; forms : of procedures -> list of these
(define (compile-procedures p forms)
  (define names
    (for/list ([_ (in-list forms)] [k (in-naturals)])
      (string->symbol (format "section-~a" k))))
  (define form
    `(linklet (,(functions-used p)) (procedures)
       ,@(for/list ([name (in-list names)] [f (in-list forms)]) `(define-values (,name) ,f))
       (define-values (procedures) (list ,@names))))
  (define linklet (compile-linklet form 'mechanics))
  ;; every operation of the algebra, under its name, for where there is no primitive
  (define functions (apply make-instance 'functions #f 'constant (flonum-functions)))
  (instance-variable-value (instantiate-linklet linklet (list functions)) 'procedures))

;; The operations a program takes from `functions`.
(define (functions-used p)
  (remove-duplicates
   (for*/list ([i (in-vector (program-instructions p))]
               [name (in-value (instruction-operation i))]
               #:unless (or (memq name '(negate solve component wrapped))
                            (primitive-for name (length (instruction-operands i)))))
     name)
   eq?))

;; A procedure of the flvector of all values, and of rooms, which it does not need.
(define (section->procedure p s in-memory)
  `(lambda (values rooms)
     ,(bind-values p (section-start s) (section-end s) 'values
                   (lambda (reference)
                     (for/list ([k (in-range (section-start s) (section-end s))]
                                #:when (hash-ref in-memory k #f))
                       `(unsafe-flvector-set! values ,k ,(reference (place k))))))))

;; A procedure from the inputs to the outputs.
(define (whole->procedure p)
  `(lambda (input output)
     ,(bind-values p (program-inputs p) (+ (program-inputs p) (program-length p)) 'input
                   (lambda (reference)
                     (for/list ([o (in-vector (program-outputs p))] [k (in-naturals)])
                       `(unsafe-flvector-set! output ,k ,(reference o)))))))

;; The form that computes the values from one place on and before another; those from elsewhere are
;; read from the flvector of that name, where they are first needed.
;; (stores reference) : the forms at its end; reference : operand -> form
(define (bind-values p start end from stores)
  (define bound (make-hasheqv))
  (define (name i) (hash-ref bound i #f))
  (define (bind! i) (hash-set! bound i (string->symbol (format "v~a" i))) (name i))
  (define (load i) `(unsafe-flvector-ref ,from ,i))
  (define (reference operand)
    (cond [(not (place? operand)) (real->double-flonum operand)]
          [else (define i (place-index operand))
                (or (name i) (load i))]))
  (define (body k)
    (if (= k end)
        `(begin ,@(stores reference) (void))
        (let ([i (instruction-at p k)])
          (with-loads (instruction-operands i)
            (lambda ()
              (define code (instruction->form i (map reference (instruction-operands i))))
              `(let-values ([(,(bind! k)) ,code]) ,(body (+ k 1))))))))
  (define (with-loads operands inside)
    (cond [(null? operands) (inside)]
          [(and (place? (car operands)) (not (name (place-index (car operands)))))
           (define i (place-index (car operands)))
           `(let-values ([(,(bind! i)) ,(load i)]) ,(with-loads (cdr operands) inside))]
          [else (with-loads (cdr operands) inside)]))
  (body start))

;; forms : of the operands
(define (instruction->form i forms)
  (define operation (instruction-operation i))
  (define primitive (primitive-for operation (length forms)))
  (cond [primitive `(,primitive ,@forms)]
        [(eq? operation 'negate) `(unsafe-fl* -1.0 ,@forms)]
        [(eq? operation 'wrapped) (apply wrapping forms)]
        [else `(,operation ,@forms)]))

;; As `wrap` of algebra/expression/operation.rkt has it.  NaN stays NaN.
(define (wrapping x low cut period)
  (define turns `(unsafe-flfloor (unsafe-fl/ (unsafe-fl- ,x ,low) ,period)))
  `(if (if (unsafe-fl<= ,low ,x) (unsafe-fl< ,x ,cut) #f)
       ,x
       (let-values ([(y) (unsafe-fl- ,x (unsafe-fl* ,period ,turns))])
         (if (unsafe-fl< y ,low) ,low (if (unsafe-fl>= y ,cut) ,low y)))))

(define (primitive-for operation arguments)
  (case operation
    [(add) 'unsafe-fl+]
    [(subtract) 'unsafe-fl-]
    [(multiply) 'unsafe-fl*]
    [(divide) 'unsafe-fl/]
    [else (and (flonum-primitive operation arguments)
               (string->symbol (format "unsafe-fl~a" operation)))]))
