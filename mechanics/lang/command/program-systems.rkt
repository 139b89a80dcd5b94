#lang racket/base
;; The systems of a program, ready for export: those that it hands to `export-system`; if it calls
;; that for none, the systems whose motions it follows while it runs.

(require racket/list
         racket/path
         racket/string
         "run-program.rkt"
         "../program-file.rkt"
         "../../generic/describe.rkt" "../../generic/up-down.rkt"
         "../../motion/observed-systems.rkt"
         (only-in "../../motion/system/parametric-system.rkt" derivative-for)
         "../../scale/export/export-system.rkt" "../../scale/export/exported-system.rkt"
         "../../scale/export/variable-names.rkt"
         "../../value/shape.rkt")

(provide program-systems (struct-out findings) (struct-out candidate))

;; systems : candidates, in the order of the program
;; error   : message of the error that ended the program early, or #f
;; exited? : did it end itself, by `exit`?
(struct findings (systems error exited?) #:authentic)

;; name   : string, for the command line, files and functions
;; start  : numbers of the program's own motion, the state's and the parameters'; or #f
;; system : exported, or a string that says why there is none
(struct candidate (name start definition system) #:authentic)

;; who : in whose name is complained; name : of the file, as it was given -> findings
(define (program-systems who file name)
  (check-program who name file)
  (define stx (call-with-program file (lambda (port) (read-whole-program who name file port))))
  (define-values (handed motions) (values '() '()))
  (define end
    (outcome-end
     (call-receiving-exports
      (lambda (s) (set! handed (cons s handed)))
      (lambda ()
        (call-watching-systems
         (lambda (maker ps state) (set! motions (with-motion maker ps state motions)))
         (lambda () (run-program stx file #:shown void)))))))
  (findings (if (pair? handed)
                (for/list ([s (in-list (reverse handed))])
                  (candidate (exported-name s) #f (exported-definition s) s))
                (candidates (reverse motions) file))
            (and end (early-end-message end))
            (and end (not (early-end-message end)))))

;; ---------------------------------------------------------------------------
;; Systems that are followed

;; maker : a state derivative; or, with parameters, the procedure that makes one of them
(struct followed (maker parameters state) #:authentic)

;; A program may make its system anew for each motion.
(define most-motions 500)

;; motions : followed, the last first
(define (with-motion maker ps state motions)
  (define derivative (if (null? ps) (derivative-for maker '()) maker))
  (define (same? f)
    (and (eq? derivative (followed-maker f))
         (= (length ps) (length (followed-parameters f)))
         (same-shape? state (followed-state f))))
  (if (or (>= (length motions) most-motions) (ormap same? motions))
      motions
      (cons (followed derivative ps state) motions)))

;; -> candidates, each system once
(define (candidates motions file)
  (for/fold ([done '()] #:result (reverse done)) ([f (in-list motions)])
    (define name (fresh (system-name f file) (map candidate-name done)))
    (define c (followed->candidate f name file))
    (if (ormap (lambda (other) (same-system? c other)) done) done (cons c done))))

(define (same-system? a b)
  (define-values (x y) (values (candidate-system a) (candidate-system b)))
  (and (exported? x) (exported? y) (equal? (exported-slope x) (exported-slope y))))

;; The name of the program's function; of a state derivative that the library made, the file's.
(define (system-name f file)
  (define printed (value->datum (followed-maker f)))
  (define name
    (if (symbol? printed) printed (path-replace-extension (file-name-from-path file) #"")))
  (define plain (car (identifiers (list (string->symbol (format "~a" name))) '())))
  (if (identifier? plain) plain (string-append plain "_system")))

(define (fresh name taken [k 2])
  (define other (format "~a_~a" name k))
  (cond [(not (member name taken)) name]
        [(member other taken) (fresh name taken (+ k 1))]
        [else other]))

;; Numbers given to the maker become parameters p0, p1 ... of the code, unless it decides by them.
(define (followed->candidate f name file)
  (define ps (followed-parameters f))
  (define symbols
    (for/list ([p (in-list ps)] [k (in-naturals)])
      (if (real? p) (string->symbol (format "p~a" k)) p)))
  (define general (exported-or-reason f name file symbols))
  (define general? (exported? general))
  (candidate name
             (numbers-of (cons (followed-state f) (if general? (filter real? ps) '())))
             (definition-of f file (if general? symbols ps))
             (if general? general (exported-or-reason f name file ps))))

;; xs : states and numbers -> their scalars as flonums; or #f where there are symbols
(define (numbers-of xs)
  (define all (append-map scalars xs))
  (and (andmap real? all) (map real->double-flonum all)))

;; ps : symbols or values in place of the parameters -> exported, or a string
(define (exported-or-reason f name file ps)
  (define maker (followed-maker f))
  (let/ec return
    (make-exported 'export
                   (if (null? ps) maker (lambda (s) ((derivative-for maker ps) s)))
                   ;; of a state that was being differentiated only the shape is needed
                   (scalars->structure (followed-state f) (lambda (_) 0)) name #f #f
                   #:definition (definition-of f file ps)
                   #:otherwise return)))

(define (definition-of f file ps)
  (define maker (value->text (followed-maker f)))
  (format "~a, of ~a"
          (if (null? ps) maker (format "(~a ~a)" maker (string-join (map value->text ps) " ")))
          (file-name-from-path file)))
