#lang racket/base
;; The machine code of a method with that of a right-hand side.
;;
;; The formulas of the method (formulas.rkt) become procedures: a step tried, and accepted; what an
;; interpolant needs, and its value.  They do what the Racket code of the method does, operation for
;; operation.
;;
;; They work in one flvector, the *room*: the error of a step, its divisor and h, then vectors of n
;; components, those of the slopes and w.  The present slope is an flvector of its own, as the
;; states are.  A step of few components is straight code (step-code.rkt); else its stages are loops
;; over vectors, two components at a time (numeric/machine/elements.rkt), and calls of the rates.

(require racket/list
         "expandable.rkt" "step-code.rkt"
         "../machine/assembler.rkt" "../machine/elements.rkt" "../machine/executable.rkt"
         "../machine/straight-code.rkt")

(provide (struct-out method-formulas) room-length kept-length
         (protect-out method-code))

;; What formulas.rkt has defined: stages of a step, its error, stages of an interpolant and
;; coefficients of its polynomial.  last : the name of the slope at the end of the step; it is that
;; of a stage, or taken when the step is accepted
(struct method-formulas (slopes error further coefficients last) #:authentic)

;; ---------------------------------------------------------------------------
;; Room

(define results 3)

(define (room-vectors formulas)
  (remove-duplicates
   (list* 'w 'k0 (append (stage-names (method-formulas-slopes formulas))
                         (stage-names (method-formulas-further formulas))))
   eq?))

(define (stage-names stages) (map car (first stages)))

(define (last-taken? formulas)
  (memq (method-formulas-last formulas) (stage-names (method-formulas-slopes formulas))))

;; So many numbers are in the room, and with an interpolant.
(define (room-length formulas n) (+ results (* n (length (room-vectors formulas)))))
(define (kept-length formulas n) (* n (length (method-formulas-coefficients formulas))))

;; What the flvector of the present slope is called: as the last one, if that is no stage.
(define (slope-name formulas)
  (if (last-taken? formulas) 'slope (method-formulas-last formulas)))

;; name -> where that vector is
(define (places-in-room formulas n base)
  (for/hasheq ([name (in-list (room-vectors formulas))] [k (in-naturals)])
    (values name (vector-at base (* 8 (+ results (* n k)))))))

(define (places-of-coefficients formulas n base)
  (for/hasheq ([c (in-list (method-formulas-coefficients formulas))] [k (in-naturals)])
    (values (kept-name (first c)) (vector-at base (* 8 n k)))))

(define (kept-name c) (string->symbol (format "kept-~a" c)))

(define (with-places places more)
  (for/fold ([places places]) ([(name place) (in-hash more)])
    (hash-set places name place)))

;; ---------------------------------------------------------------------------
;; Code

;; Of a step with more components, or rates of more instructions, straight code is no faster or
;; takes too long to write.
(define-values (most-components most-instructions) (values 8 200))

;; rates : machine-rates; -> list of procedures, or #f
(define (method-code formulas n m)
  (define instructions (machine-rates-instructions m))
  (define straight?
    (and (<= n most-components) (<= (vector-length instructions) most-instructions)))
  (define a (make-assembly))
  (define rates
    (written a (lambda ()
                 (write-procedure! a n (machine-rates-parameters m) instructions
                                   (machine-rates-outputs m)))))
  (define-syntax-rule (entry (type ...) form)
    (list (label-place (written a (lambda () form))) type ...))
  (define-values (v x) (values 'flvector 'flonum))
  (define entries
    (list (entry (v v v) (write-begin! a n formulas rates))
          (entry (x v v v v v)
                 (if straight?
                     (write-straight-try! a n formulas m)
                     (write-try! a n formulas rates)))
          (entry (v v v v v v) (write-accept! a n formulas rates))
          (entry (x v v v v v v) (write-prepare! a n formulas rates))
          (entry (x v v) (write-value! a n formulas))))
  (machine-procedures (assembly->bytes a) entries))

;; -> the label of what is written
(define (written a write)
  (define l (make-label))
  (label-here! a l)
  (write)
  l)

;; y slope parameters
(define (write-begin! a n formulas rates)
  (with-vectors a '(y slope parameters)
    (lambda (places) (call-rates! a places 'y 'slope rates))))

(define (call-rates! a places from to rates)
  (lea! a rdi (start-of places from))
  (lea! a rsi (start-of places to))
  (lea! a rdx (start-of places 'parameters))
  (call! a rates))

(define (start-of places name)
  (define v (hash-ref places name))
  (behind (vector-at-base v) (vector-at-distance v)))

;; h y z slope room parameters: z, the slopes, and the error
(define (write-try! a n formulas rates)
  (define slope (slope-name formulas))
  (with-vectors a (list 'y 'z slope 'room 'parameters)
    (lambda (given)
      (define places (with-room formulas n given))
      (emit-elements! a n places `((store k0 (at ,slope i))))
      (write-stages! a n places 'y 'z (method-formulas-slopes formulas) rates)
      (write-error! a n places (method-formulas-error formulas)))))

(define (with-room formulas n given)
  (define base (vector-at-base (hash-ref given 'room)))
  (with-places (with-places given (places-in-room formulas n base))
    (hasheq 'error (vector-at base 0) 'divisor (vector-at base 8))))

;; The same.
(define (write-straight-try! a n formulas m)
  (define slope (slope-name formulas))
  (with-vectors a (list 'y 'z slope 'room 'parameters)
    (lambda (given)
      (define places (with-room formulas n given))
      (define (component name i)
        (define v (hash-ref places name))
        (behind (vector-at-base v) (+ (vector-at-distance v) (* 8 i))))
      (define (input k)
        (cond [(< k n) (component 'y k)]
              [(< k (+ n n)) (component slope (- k n))]
              [(= k (+ n n)) (behind (vector-at-base (hash-ref given 'room)) 16)]
              [else (component 'parameters (- k n n 1))]))
      (define-values (code results)
        (step-code m (method-formulas-slopes formulas) (method-formulas-error formulas)))
      (store-sd! a (input (+ n n)) 0)
      (write-straight-code! a code (+ n n 1 (machine-rates-parameters m)) input
                            (for*/list ([(name operands) (in-hash results)]
                                        #:when (hash-ref places name #f)
                                        #:unless (eq? name 'y)
                                        [i (in-range (vector-length operands))])
                              (cons (vector-ref operands i) (component name i)))))))

;; old y z slope room parameters: y becomes z, and old what it was
(define (write-accept! a n formulas rates)
  (define slope (slope-name formulas))
  (with-vectors a (list 'old 'y 'z slope 'room 'parameters)
    (lambda (given)
      (define places (with-room formulas n given))
      (emit-elements! a n places '((store old (at y i)) (store y (at z i))))
      (if (last-taken? formulas)
          (emit-elements! a n places `((store slope (at ,(method-formulas-last formulas) i))))
          (call-rates! a places 'y slope rates)))))

;; h old y slope room kept parameters: further slopes, and the coefficients
(define (write-prepare! a n formulas rates)
  (with-vectors a (list 'old 'y (slope-name formulas) 'room 'kept 'parameters)
    (lambda (given)
      (define kept (vector-at-base (hash-ref given 'kept)))
      (define places
        (with-places (with-room formulas n given) (places-of-coefficients formulas n kept)))
      (write-stages! a n places 'old #f (method-formulas-further formulas) rates)
      (write-coefficients! a n places (method-formulas-coefficients formulas)))))

(define (write-stages! a n places from to stages rates)
  (define (reach! name terms)
    (emit-elements! a n (with-length a places)
                    `((store ,name (fl+ (at ,from i) (fl* h (weighted i ,@terms)))))))
  (for ([s (in-list (first stages))])
    (reach! 'w (cdr s))
    (call-rates! a places 'w (car s) rates))
  (define end (second stages))
  (cond [(pair? end) (reach! to end)]
        [end (emit-elements! a n places `((store ,to (at w i))))]))

;; Sums of squares first, component after component.
(define (write-error! a n places error)
  (define-values (means formulas dividend divisor) (apply values error))
  (define sums (for/list ([m (in-list means)] [r (in-naturals 13)]) (number-in r)))
  (for ([s (in-list sums)])
    (xorpd! a (number-in-register s) (number-in-register s)))
  (define with-sums
    (for/fold ([places places]) ([m (in-list means)] [s (in-list sums)])
      (hash-set places (first m) s)))
  (emit-elements! a n with-sums
                  `((local scale (fl+ 1.0 (flmax (flabs (at y i)) (flabs (at z i)))))
                    ,@(append*
                       (for/list ([m (in-list means)])
                         `((local x (fl/ (weighted i ,@(rest m)) scale))
                           (total ,(first m) (fl* x x)))))))
  (emit-elements! a 1
                  (with-length a with-sums)
                  `(,@(for/list ([m (in-list means)])
                        `(local ,(first m) (flsqrt (fl/ ,(first m) ,n))))
                    ,@(for/list ([f (in-list formulas)]) (cons 'local f))
                    (local d ,divisor)
                    (store divisor d)
                    (store error (fl/ ,dividend d)))))

;; A coefficient that others are made of stays in a register as well.
(define (write-coefficients! a n places coefficients)
  (define used (flatten (map rest coefficients)))
  (emit-elements! a n (with-length a places)
                  (append*
                   (for/list ([c (in-list coefficients)])
                     (define-values (name formula) (values (first c) (second c)))
                     (if (memq name used)
                         `((local ,name ,formula) (store ,(kept-name name) ,name))
                         `((store ,(kept-name name) ,formula)))))))

;; theta kept out: x + θ (c₀ + (1 − θ) (c₁ + θ (c₂ + ...)))
(define (write-value! a n formulas)
  (define-values (theta other) (values 15 14))
  (unpcklpd! a 0 0)
  (movapd! a theta 0)
  (movapd! a other (constant 1.0))
  (subpd! a other theta)
  (add! a rdi flvector-data)
  (add! a rsi flvector-data)
  (emit-elements! a n
                  (with-places (places-of-coefficients formulas n rdi)
                    (hasheq 'out (vector-at rsi 0)
                            'theta (number-in theta) 'other (number-in other)))
                  `((store out ,(nested (map first (method-formulas-coefficients formulas))))))
  (ret! a))

(define (nested names [factor 'theta] [other 'other])
  (define c `(at ,(kept-name (first names)) i))
  (if (null? (rest names))
      c
      `(fl+ ,c (fl* ,factor ,(nested (rest names) other factor)))))

;; ---------------------------------------------------------------------------
;; What a procedure is given

(define own-registers (list rbx rbp r12 r13 r14 r15))

;; A procedure of h, perhaps, and of flvectors by these names, up to six; (write places) writes what
;; it does, while h is on the stack twice and rsp a multiple of 16.
(define (with-vectors a names write)
  (for ([r (in-list own-registers)]) (push! a r))
  (add! a rsp -24)
  (unpcklpd! a 0 0)
  (store-pd! a (behind rsp 0) 0)
  (for ([_ (in-list names)] [r (in-list own-registers)]
        [given (in-list (list rdi rsi rdx rcx r8 r9))])
    (lea! a r (behind given flvector-data)))
  (write (for/hasheq ([name (in-list names)] [r (in-list own-registers)])
           (values name (vector-at r 0))))
  (add! a rsp 24)
  (for ([r (in-list (reverse own-registers))]) (pop! a r))
  (ret! a))

;; h in a register.
(define (with-length a places)
  (movupd! a 15 (behind rsp 0))
  (hash-set places 'h (number-in 15)))
