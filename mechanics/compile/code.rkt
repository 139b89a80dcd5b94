#lang racket/base
;; From programs to machine code, by the compiler of Racket.
;;
;; A program becomes the body of a *linklet*, the form below modules that Racket
;; hands to its compiler: it knows the primitives and nothing of macros, so that
;; compiling costs a few milliseconds per hundred instructions.  Within one
;; procedure the compiler keeps flonums unboxed.
;;
;; It interprets, though, what is larger than a limit.  So the instructions are
;; divided into *sections*, each a closed procedure of its own; a value that a
;; later section needs passes through a scratch vector.  The matrix of a system of
;; many unknowns, whose entries are more than a section holds, is filled by sections
;; of its own; many values are delivered by such.  Room for that, and for the
;; systems of equations that are solved, is made once for many runs, one after the
;; other; several threads may run the code at once, each with room of its own.

(require racket/linklet
         racket/list
         "flonum-functions.rkt" "program.rkt" "program-sections.rkt"
         "../numeric/linear-algebra/factored-system.rkt" "../numeric/linear-algebra/symmetric-system.rkt")

(provide (protect-out program->maker))

;; -> (-> (input output -> void)), which makes procedures from one flvector into
;; another, to be used by one thread at a time each.
(define (program->maker p)
  (define linklet (compile-linklet (program->form p) 'mechanics))
  (instance-variable-value (instantiate-linklet linklet (list (functions))) 'make-run))

;; Every operation of the algebra, under its name, for where there is no primitive.
(define (functions)
  (apply make-instance 'functions #f 'constant
         'solve-dense! solve-dense!
         'solve-symmetric! solve-symmetric!
         (flonum-functions)))

;; ---------------------------------------------------------------------------
;; The linklet

(define (program->form p)
  (define sections (divide p))
  (define scratch (allocate-scratch p sections))
  (define names
    (for/list ([_ (in-list sections)] [k (in-naturals)])
      (string->symbol (format "section-~a" k))))
  `(linklet (,(list* 'solve-dense! 'solve-symmetric! (functions-used p))) (make-run)
     ,@(for/list ([name (in-list names)] [s (in-list sections)])
         `(define-values (,name)
            ,(cond [(filling? s) (filling->procedure p s scratch)]
                   [(delivery? s) (delivery->procedure p s scratch)]
                   [else (section->procedure p s scratch)])))
     (define-values (make-run)
       (lambda ()
         (let-values ([(scratch) (make-flvector ,(hash-count scratch))]
                      [(systems) (vector ,@(systems-room p))])
           (lambda (input output)
             (begin ,@(for/list ([name (in-list names)]) `(,name input output scratch systems))
                    (void))))))))

;; Where systems are solved: three vectors for a size, which systems of that size share.
(define (systems-room p)
  (append*
   (for/list ([n (in-list (system-sizes p))])
     `((make-flvector ,(* n n)) (make-flvector ,n) (make-fxvector ,n)))))

(define (systems-place p system)
  (* 3 (index-of (system-sizes p) (system-unknowns system))))

;; ---------------------------------------------------------------------------
;; A section

;; Values are bound in their order; those from elsewhere where they are first
;; needed.
(define (section->procedure p s scratch)
  (define bound (make-hasheqv))
  (define (name i) (hash-ref bound i #f))
  (define (bind! i) (hash-set! bound i (string->symbol (format "v~a" i))) (name i))
  (define (reference operand)
    (if (place? operand) (name (place-index operand)) (real->double-flonum operand)))
  (define (body k)
    (if (= k (section-end s))
        `(begin ,@(stores p s scratch name reference) (void))
        (let ([instruction (instruction-at p k)])
          (with-loads (operands-read instruction)
            (lambda ()
              (define code (instruction->form p instruction reference))
              `(let-values ([(,(bind! k)) ,code]) ,(body (+ k 1))))))))
  (define (with-loads operands inside)
    (cond [(null? operands) (inside)]
          [(and (place? (car operands)) (not (name (place-index (car operands)))))
           (define i (place-index (car operands)))
           (define v (bind! i))
           `(let-values ([(,v) ,(load p scratch i)]) ,(with-loads (cdr operands) inside))]
          [else (with-loads (cdr operands) inside)]))
  `(lambda (input output scratch systems) ,(body (section-start s))))

(define (load p scratch i)
  (if (< i (program-inputs p))
      `(unsafe-flvector-ref input ,i)
      `(unsafe-flvector-ref scratch ,(hash-ref scratch i))))

;; What is stored at the end of a section: its values that are wanted later, and
;; the outputs it computes; the first one stores the outputs nobody computes.
(define (stores p s scratch name reference)
  (append
   (for*/list ([k (in-range (section-start s) (section-end s))]
               [slot (in-value (hash-ref scratch k #f))]
               #:when slot)
     `(unsafe-flvector-set! scratch ,slot ,(name k)))
   (for/list ([operand (in-vector (program-outputs p))] [i (in-naturals)]
              #:when (and (section-outputs? s) (stored-by? p s operand)))
     (define value
       (if (and (place? operand) (< (place-index operand) (program-inputs p)))
           (load p scratch (place-index operand))
           (reference operand)))
     `(unsafe-flvector-set! output ,i ,value))))

(define (stored-by? p s operand)
  (define first (program-inputs p))
  (define i (and (place? operand) (place-index operand)))
  (if (and i (>= i first))
      (< (- (section-start s) 1) i (section-end s))
      (= first (section-start s))))

;; reference : operand -> form
(define (instruction->form p instruction reference)
  (define operation (instruction-operation instruction))
  (define operands (operands-read instruction))
  (define forms (map reference operands))
  (define primitive (primitive-for operation (length forms)))
  (cond [primitive `(,primitive ,@forms)]
        [(eq? operation 'negate) `(unsafe-fl* -1.0 ,@forms)]
        [(eq? operation 'solve)
         (solving forms (system-unknowns instruction) (systems-place p instruction)
                  (if (symmetric-system? instruction) 'solve-symmetric! 'solve-dense!))]
        [(eq? operation 'component) `(unsafe-flvector-ref ,(car forms) ,(cadr operands))]
        [(eq? operation 'wrapped) (apply wrapping forms)]
        [else `(,operation ,@forms)]))

;; The value of a system of n unknowns, given as rows of [A b], is the flvector of its
;; solution, good until the next system is solved.  solve! : the name of what solves it
(define (solving entries n place solve!)
  (in-system place
    `(begin ,@(storing entries 0 n)
            (,solve! A ,n (unsafe-vector-ref systems ,(+ place 2)) b)
            b)))

(define (in-system place body)
  `(let-values ([(A) (unsafe-vector-ref systems ,place)]
                [(b) (unsafe-vector-ref systems ,(+ place 1))])
     ,body))

;; from : the number of the first of the entries
(define (storing entries from n)
  (define width (+ n 1))
  (for/list ([x (in-list entries)] [k (in-naturals from)])
    (define i (quotient k width))
    (define j (remainder k width))
    (if (= j n)
        `(unsafe-flvector-set! b ,i ,x)
        `(unsafe-flvector-set! A ,(+ (* i n) j) ,x))))

(define (filling->procedure p f scratch)
  (define system (instruction-at p (filling-system f)))
  (define (form operand)
    (if (place? operand) (load p scratch (place-index operand)) (real->double-flonum operand)))
  `(lambda (input output scratch systems)
     ,(in-system (systems-place p system)
        `(begin ,@(storing (map form (entries-of p f)) (filling-from f)
                           (system-unknowns system))
                (void)))))

(define (delivery->procedure p d scratch)
  `(lambda (input output scratch systems)
     ,@(for/list ([operand (in-list (outputs-of p d))] [k (in-naturals (delivery-from d))])
         (define value
           (if (place? operand)
               (load p scratch (place-index operand))
               (real->double-flonum operand)))
         `(unsafe-flvector-set! output ,k ,value))
     (void)))

;; As `wrap` of algebra/expression/operation.rkt has it.  What is not a number stays so.
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

;; The operations a program takes from `functions`.
(define (functions-used p)
  (remove-duplicates
   (for/list ([i (in-vector (program-instructions p))]
              #:unless (in-place? (instruction-operation i) (instruction-operands i)))
     (instruction-operation i))
   eq?))

(define (in-place? name operands)
  (or (memq name '(negate solve component wrapped)) (primitive-for name (length operands))))
