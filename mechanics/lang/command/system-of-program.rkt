#lang racket/base
;; A system that a program follows, as a system for export: under the name that the program or the
;; book gives it, with parameters where the program passes them to the maker of the state
;; derivative.

(require racket/list
         racket/path
         racket/string
         "definition-heads.rkt"
         "../../error/computed-once.rkt"
         "../../scale/export/exported-system.rkt" "../../scale/export/variable-names.rkt"
         "../../generic/describe.rkt"
         (only-in "../../motion/system/parametric-system.rkt" derivative-for)
         "../../value/shape.rkt")

(provide (struct-out followed) (struct-out candidate)
         make-knowledge state-by-pattern systems-of)

;; maker : a state derivative; or, with parameters, the procedure that makes one of them
(struct followed (maker parameters state) #:authentic)

;; name   : string, for the command line, files and functions
;; start, values : lists of numbers, of the program's own motion; or #f
;; system : exported, or a string that says why there is none
(struct candidate (name start values definition system) #:authentic)

;; heads : list of (-> hasheq), of the program and of the book; defined : alist of names and
;; procedures; file : where the program is
(struct knowledge (heads defined file) #:authentic)

(define (make-knowledge stx defined file)
  (knowledge (list (once (lambda () (program-heads stx))) (once book-heads)) defined file))

;; -> candidates, each system once
(define (systems-of all k derivatives?)
  (for/fold ([done '()] #:result (reverse done)) ([f (in-list all)])
    (define name (fresh (system-name f k) (map candidate-name done)))
    (define s (followed->candidate f k name derivatives?))
    (if (ormap (lambda (other) (same-system? s other)) done) done (cons s done))))

(define (same-system? a b)
  (define-values (x y) (values (candidate-system a) (candidate-system b)))
  (and (exported? x) (exported? y)
       (equal? (exported-slope x) (exported-slope y))
       (equal? (exported-variables x) (exported-variables y))))

;; ---------------------------------------------------------------------------
;; Names

;; The names of the value in the program.
(define (names-of x k)
  (for/list ([d (in-list (knowledge-defined k))] #:when (eq? x (cdr d))) (car d)))

;; These, and the names that it prints with.
(define (names-in x k)
  (append (names-of x k) (filter symbol? (flatten (value->datum x)))))

;; look : heads name -> a value for k, or #f
(define (look-up k x look)
  (define names (names-in x k))
  (for*/or ([heads (in-list (knowledge-heads k))] [name (in-list names)]) (look (heads) name)))

(define (system-name f k)
  (define maker (followed-maker f))
  (define own-names (names-of maker k))
  (define name
    (cond [(pair? own-names) (car own-names)]
          [(look-up k maker long-name)]
          [else (file-name-from-path (path-replace-extension (knowledge-file k) #""))]))
  (identifier-of
   (regexp-replaces (format "~a" name)
                    '([#rx"^[LHT]-" ""] [#rx"(-state|-system)?-(derivative|sysder)$" ""]))))

;; A defined name of more than a letter, such as L; or #f
(define (long-name heads name)
  (and (hash-ref heads name #f) (< 1 (string-length (symbol->string name))) name))

(define (identifier-of text)
  (define plain (car (identifiers (list (string->symbol text)) '())))
  (if (identifier? plain) plain (string-append plain "_system")))

(define (fresh name taken [k 2])
  (define other (format "~a_~a" name k))
  (cond [(not (member name taken)) name]
        [(member other taken) (fresh name taken (+ k 1))]
        [else other]))

;; A state of zeros, of the shape that the arguments of the Lagrangian show; or #f
(define (state-by-pattern derivative k)
  (look-up k derivative pattern-state))

;; ---------------------------------------------------------------------------
;; Parameters

(define (followed->candidate f k name derivatives?)
  (define ps (followed-parameters f))
  (define symbols (and (pair? ps) (parameter-symbols f k)))
  (define (attempt symbols) (exported-or-reason f k name symbols derivatives?))
  (define general (and symbols (attempt symbols)))
  (define s (if (exported? general) general (attempt #f)))
  (candidate name (numbers-of (followed-state f))
         (if (eq? s general) (append* (map numbers-of (filter numeric? ps))) '())
         (definition-of f k symbols) s))

(define (numbers-of x)
  (define all (scalars x))
  (and (andmap real? all) (map real->double-flonum all)))

;; In place of each numeric parameter symbols of its shape; others stay.
(define (parameter-symbols f k)
  (define ps (followed-parameters f))
  (define names
    (or (look-up k (followed-maker f)
                 (lambda (heads name) (parameter-names heads name (length ps))))
        (for/list ([i (in-range (length ps))]) (string->symbol (format "p~a" i)))))
  (for/list ([p (in-list ps)] [name (in-list names)])
    (cond [(not (numeric? p)) p]
          [(= 1 (shape-length p)) (scalars->structure p (lambda (_) name))]
          [else (scalars->structure p (lambda (j) (string->symbol (format "~a~a" name j))))])))

;; symbols : in place of the parameters, or #f -> exported, or a string
(define (exported-or-reason f k name symbols derivatives?)
  (define-values (maker state) (values (followed-maker f) (followed-state f)))
  (define ps (or symbols (followed-parameters f)))
  (define order (and symbols (filter symbol? (append-map scalars symbols))))
  (let/ec return
    (make-exported 'export
                   (if (null? ps) maker (lambda (s) ((derivative-for maker ps) s)))
                   ;; of a state that was being differentiated only the shape is needed
                   (scalars->structure state (lambda (_) 0)) name order derivatives?
                   #:names (variable-names f k)
                   #:definition (definition-of f k symbols)
                   #:otherwise return)))

;; The maker of a state derivative of parameters says nothing of states; the state derivative
;; prints the Lagrangian's name.
(define (variable-names f k)
  (define-values (maker ps state)
    (values (followed-maker f) (followed-parameters f) (followed-state f)))
  (or (names-by maker state k)
      (and (pair? ps) (names-by (derivative-for maker ps) state k))))

;; A Hamiltonian made of a Lagrangian has momenta where the Lagrangian's pattern has velocities.
(define (names-by maker state k)
  (define names (look-up k maker (lambda (heads name) (state-names heads name state))))
  (define n (and names (quotient (length names) 2)))
  (if (and names (odd? (length names)) (memq 'Lagrangian->Hamiltonian (names-in maker k)))
      (append (take names (+ n 1))
              (for/list ([q (in-list (take (cdr names) n))])
                (and q (string->symbol (format "p_~a" q)))))
      names))

(define (definition-of f k symbols)
  (define maker (value->text (followed-maker f)))
  (define ps (or symbols (followed-parameters f)))
  (format "~a, of ~a"
          (if (null? ps) maker (format "(~a ~a)" maker (string-join (map value->text ps) " ")))
          (file-name-from-path (knowledge-file k))))
