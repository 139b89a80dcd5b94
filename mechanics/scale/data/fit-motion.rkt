#lang racket/base
;; Motions fitted to measured data: the start and the parameters of a system for which the
;; squares of the differences add up to the least.
;;
;; The parameters join the state, as components that stay as they are, and the displacements of
;; all that is fitted are followed beside the motion by the equations of variations: so one
;; motion gives every measured quantity with its derivatives, which the method of Levenberg and
;; Marquardt takes.  Where the data do not change with some unknowns, or with some of them
;; together, these are named and nothing is returned.

(require racket/flonum
         racket/list
         "measured-data.rkt" "motion-fit.rkt"
         "../export/state-variables.rkt"
         "../../calculus/derivative.rkt"
         "../../dynamics/map/period-check.rkt"
         "../../error/complain.rkt" "../../error/failure.rkt" "../../error/message-words.rkt"
         "../../error/progress.rkt" "../../error/spelling.rkt"
         "../../generic/define-plain.rkt"
         "../../generic/function-check.rkt" "../../generic/up-down.rkt"
         "../../generic/wrong-argument.rkt"
         "../../motion/evolve-trajectory.rkt" "../../motion/linearized-flow.rkt"
         "../../motion/observed-systems.rkt" "../../motion/system/check.rkt"
         (only-in "../../motion/system/parametric-system.rkt" derivative-for)
         "../../numeric/flvector.rkt" "../../numeric/optimization/Levenberg-Marquardt.rkt"
         "../../value/matrix/matrix.rkt"
         "../../value/shape.rkt" (only-in "../../value/structure.rkt" ref structure->list))

(provide fit-motion)

(define who 'fit-motion)

;; maker : a state derivative, or a procedure that makes one of the parameters
;; start : a state, near which the motion begins; #:parameters : list of (name value)
;; #:measured : state -> the value measured, a number or a tuple; the whole state without time if #f
;; #:deviation : standard deviation of the data, one for all or a list; #f where it is not known
;; -> motion-fit
(define-plain (fit-motion maker start data
                          #:parameters [guesses '()] #:hold [held '()]
                          #:measured [measured #f] #:deviation [deviation #f]
                          #:tolerance [tolerance 1e-10] #:progress? [progress? (report-progress)])
  (check-guesses guesses)
  (check-tolerance who tolerance)
  (define ps (map cadr guesses))
  (check-maker who maker ps)
  (define derivative (derivative-for maker ps))
  (check-derivative who derivative start)
  (define clock? (timed-state? derivative start))
  (define rows
    (measured-rows who data (if clock? (real->double-flonum (car (scalars start))) 0.0)))
  (define sigmas (check-deviations who deviation (flvector-length (measured-numbers (car rows)))))
  (define u (make-unknowns derivative start guesses clock? held))
  (check-enough rows u)
  (define evaluate
    (evaluator (joined-derivative maker (length ps)) (apply up start ps) u rows
               (measuring measured start clock? rows) sigmas tolerance))
  (note-followed maker ps start)
  (define found (call-unwatched (lambda () (search evaluate u progress?))))
  (check-determined found u)
  (result found u (apply up start ps) rows sigmas))

(define (search evaluate u progress?)
  (define-values (r _) (evaluate (unknowns-start u)))
  (unless (and r (flvector-finite? r))
    (complain who "the motion from the start has no finite values where data are"))
  (define (tried x)
    (with-handlers ([no-value? (lambda (e) (values #f #f))])
      (define-values (r columns) (evaluate x))
      (if (andmap flvector-finite? (cons r columns)) (values r columns) (values #f #f))))
  (define (shown x) (map list (unknowns-names u) (flvector->list x)))
  (call-with-progress
   progress?
   (lambda (note!)
     (define (observe x cost)
       (note-progress note! (format "~a: sum of squares ~a" who cost)))
     (least-squares who tried (unknowns-start u) #:argument shown #:observe observe))))

;; ---------------------------------------------------------------------------
;; The unknowns

;; names : symbols; places : among the scalars of state and parameters; start : flvector
(struct unknowns (names places start) #:authentic)

(define (make-unknowns derivative start guesses clock? held)
  (define names (append (suggested-names derivative start clock?) (map car guesses)))
  (define twice (check-duplicates names))
  (when twice
    (complain who "a parameter has the name of a variable of the state\n  name: ~a" twice))
  (unless (list? held) (complain-of-argument who "names that are held, a list" held))
  (for ([name (in-list held)] #:unless (memq name names))
    (complain who "there is no unknown ~a to hold~a" name
              (if (symbol? name) (among name names) "")))
  (define numbers (append (scalars start) (map cadr guesses)))
  (define places
    (for/list ([name (in-list names)] [k (in-naturals)]
               #:unless (or (memq name held) (and clock? (eqv? k 0))))
      k))
  (when (null? places) (complain who "nothing is left to fit: all is held"))
  (unknowns (for/list ([k (in-list places)]) (list-ref names k)) places
            (for/flvector ([k (in-list places)]) (real->double-flonum (list-ref numbers k)))))

(define (check-guesses guesses)
  (unless (and (list? guesses)
               (for/and ([g (in-list guesses)])
                 (and (list? g) (= 2 (length g)) (symbol? (car g)) (real? (cadr g)))))
    (complain-of-argument who "#:parameters with names and first values, as '((g 9.8) (l 1))"
                          guesses)))

(define (check-enough rows u)
  (define count (* (length rows) (flvector-length (measured-numbers (car rows)))))
  (define names (unknowns-names u))
  (when (< count (length names))
    (complain who "~a numbers were measured, and there are ~a unknowns\n  unknowns: ~a\n  ~a"
              count (length names) (named names) "#:hold tells those that are known")))

(define (named names) (joined (map symbol->string names)))

;; all : state and parameters; -> the same with these values of the unknowns
(define (with-unknowns all u x)
  (define at (for/hasheqv ([k (in-list (unknowns-places u))] [y (in-flvector x)]) (values k y)))
  (define numbers (list->vector (scalars all)))
  (scalars->structure all (lambda (k) (hash-ref at k (lambda () (vector-ref numbers k))))))

;; ---------------------------------------------------------------------------
;; Residuals and their derivatives

;; Of (up state parameter ...)
(define (joined-derivative maker n)
  (define zeros (make-list n 0))
  (with-displacements
   (lambda (all)
     (define parts (structure->list all))
     (apply up ((derivative-for maker (cdr parts)) (car parts)) zeros))))

;; -> a function of the state
(define (measuring given start clock? rows)
  (define n (flvector-length (measured-numbers (car rows))))
  (unless (or (not given) (takes-arguments? given 1))
    (complain-of-argument who "#:measured, a function of the state" given))
  (define h (or given (lambda (s) (apply up ((if clock? cdr values) (scalars s))))))
  (define m (shape-length (h start)))
  (unless (= m n)
    (complain who "each row has ~a beside the time, and ~a has ~a\n  ~a"
              (counted n "number")
              (if given "the value of #:measured" "the state") m
              "#:measured is the function of the state that was measured"))
  h)

;; -> x -> residuals, data less model, and a column of derivatives for each unknown
(define ((evaluator rates all u rows h sigmas tolerance) x)
  (define start (with-unknowns all u x))
  (define moving (for/list ([k (in-list (unknowns-places u))]) (unit-structure all k)))
  (define sizes (sizes-of u x))
  (define end (for/fold ([t -inf.0]) ([m (in-list rows)]) (flmax t (measured-time m))))
  (define tr
    (call-for-state who (lambda ()
                          (evolve-trajectory rates (apply up start moving) end
                                             #:tolerance tolerance #:progress? #f))))
  (define models+columns (for/list ([m (in-list rows)]) (at-row (tr (measured-time m)) h sigmas)))
  (define model (flvector-join (map car models+columns)))
  (define columns
    (for/list ([k (in-range (length moving))] [size (in-list sizes)])
      (define c (flvector-join (for/list ([mc (in-list models+columns)]) (list-ref mc (+ k 1)))))
      (if (negligible? c size model) (make-flvector (flvector-length c)) (flvector-scaled -1.0 c))))
  (values (difference (flvector-join (for/list ([m (in-list rows)])
                                       (weighted (measured-numbers m) sigmas)))
                      model)
          columns))

;; all : state and displacements at the time of a row -> the model and its derivatives there
(define (at-row all h sigmas)
  (define parts (structure->list all))
  (define state (ref (car parts) 0))
  (define (numbers y) (weighted (structure->flvector y (lambda (x) +nan.0)) sigmas))
  (define changes
    (for/list ([v (in-list (cdr parts))])
      (define-values (y change) (value-and-derivative-along h state (ref v 0)))
      (numbers change)))
  (cons (numbers (h state)) changes))

(define (weighted v sigmas)
  (if sigmas (for/flvector ([x (in-flvector v)] [s (in-list sigmas)]) (fl/ x s)) v))

(define (flvector-join vs) (for*/flvector ([v (in-list vs)] [x (in-flvector v)]) x))

;; The sizes of the unknowns: as they are, or as they were given, for a fitted number may be 0.
(define (sizes-of u x)
  (for/list ([x (in-flvector x)] [start (in-flvector (unknowns-start u))])
    (flmax (flabs x) (if (fl= start 0.0) 1.0 (flabs start)))))

;; Is a change of an unknown by its size too small to be seen?
(define (negligible? column size model)
  (fl<= (fl* size (norm column)) (fl* 1e-10 (norm model))))

;; ---------------------------------------------------------------------------
;; The result

(define (check-determined found u)
  (define directions (undetermined-directions found))
  (define groups
    (for/list ([v (in-list directions)])
      (for/list ([name (in-list (unknowns-names u))] [x (in-flvector v)]
                 #:when (fl> (flabs x) 1e-3))
        name)))
  (define-values (single several) (partition (lambda (g) (null? (cdr g))) groups))
  (when (pair? groups)
    (raise-singular
     who (string-append "the data do not determine all that is fitted"
                        (told "\n  without effect: " (append* single))
                        (told "\n  only together: " (remove-duplicates (append* several)))
                        "\n  #:hold tells those that are known")
     (map list (unknowns-names u) (flvector->list (linear-model-point found))))))

(define (told label names) (if (null? names) "" (string-append label (named names))))

(define (result found u all rows sigmas)
  (define x (linear-model-point found))
  (define r (linear-model-residuals found))
  (define freedom (- (flvector-length r) (flvector-length x)))
  (define sum (dot r r))
  (define variance
    (cond [sigmas 1.0]
          [(> freedom 0) (/ sum freedom)]
          [else +nan.0]))
  (define parts (structure->list (with-unknowns all u x)))
  (motion-fit (map list (unknowns-names u) (flvector->list x))
              (apply matrix-by-rows
                     (for/list ([row (in-list (inverse-normal-matrix found))])
                       (for/list ([c (in-list row)]) (* variance c))))
              (car parts) (cdr parts) (residual-rows rows r sigmas)
              sum freedom (and (not sigmas) (sqrt variance))))

;; In the units of the data
(define (residual-rows rows r sigmas)
  (define n (flvector-length (measured-numbers (car rows))))
  (for/list ([m (in-list rows)] [k (in-naturals)])
    (apply up (measured-time m)
           (for/list ([j (in-range n)])
             (* (if sigmas (list-ref sigmas j) 1.0) (flvector-ref r (+ j (* k n))))))))
